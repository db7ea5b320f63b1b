// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {

/// The log odds of success of a grasp whose terms are all zero.
inline constexpr double kSuccessBias = -7.868;

/// The weights of the GraspTerms in the log odds of success, in the order of GraspTerms::visit().
inline constexpr std::array kSuccessWeights = {
    1.014,   // friction
    1.000,   // clearance
    2.408,   // room
    1.160,   // central
    0.4863,  // across
    1.626,   // seen
    0.0,     // way
    0.0,     // noise
    0.0,     // doubt
    2.072,   // confidence
    -1.643,  // range
    1.053,   // rim
    1.295,   // shape
    0.9524,  // inner
    0.9216,  // height
};

}  // namespace quadrille

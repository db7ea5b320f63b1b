// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {

/// The log odds of success of a grasp whose terms are all zero.
inline constexpr double kSuccessBias = -8.894;

/// The weights of the GraspTerms in the log odds of success, in the order of GraspTerms::visit().
inline constexpr std::array kSuccessWeights = {
    0.1734,   // friction
    0.6669,   // reserve
    0.5000,   // clearance
    0.5000,   // room
    0.5684,   // central
    3.500,    // seen
    2.059,    // confidence
    -3.066,   // range
    1.558,    // rim
    0.05000,  // shape
    0.9396,   // inner
    0.6728,   // height
    0.7088,   // facing
    0.8968,   // filled
    0.9774,   // flat
    0.8845,   // sure
};

}  // namespace quadrille

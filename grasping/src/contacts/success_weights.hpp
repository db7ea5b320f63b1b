// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {

/// The log odds of success of a grasp whose terms are all zero.
inline constexpr double kSuccessBias = -8.617;

/// The weights of the GraspTerms in the log odds of success, in the order of GraspTerms::visit().
inline constexpr std::array kSuccessWeights = {
    1.192,   // friction
    0.5000,  // clearance
    0.5000,  // room
    0.2792,  // central
    3.547,   // seen
    2.648,   // confidence
    -2.427,  // range
    0.7253,  // rim
    0.5188,  // shape
    1.604,   // inner
    2.214,   // height
};

}  // namespace quadrille

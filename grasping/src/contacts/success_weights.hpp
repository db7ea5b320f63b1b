// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {

/// The log odds of success of a grasp whose terms are all zero, before they are calibrated.
inline constexpr double kSuccessBias = -8.087;

/// The weights of the GraspTerms in these log odds, in the order of GraspTerms::visit().
inline constexpr std::array kSuccessWeights = {
    0.2078,   // friction
    0.05000,  // reserve
    0.5000,   // clearance
    0.5000,   // room
    0.4066,   // central
    3.500,    // seen
    2.134,    // confidence
    -3.102,   // range
    1.481,    // rim
    0.05000,  // shape
    0.9315,   // inner
    0.6849,   // height
    0.8616,   // facing
    0.5232,   // filled
    1.012,    // flat
    0.8617,   // sure
};

}  // namespace quadrille

// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {

/// The log odds of success of a grasp whose terms are all zero.
inline constexpr double kSuccessBias = -5.079;

/// What each of the GraspTerms adds to the log odds, in their order.
inline constexpr std::array kSuccessWeights = {
    0.8921,  // friction
    1.000,  // clearance
    0.6729,  // room
    0.5822,  // central
    0.3846,  // across
    0.5386,  // seen
    1.615,  // confidence
    -2.645,  // range
    1.169,  // rim
    0.9664,  // shape
    1.251,  // inner
    1.915,  // height
};

}  // namespace quadrille

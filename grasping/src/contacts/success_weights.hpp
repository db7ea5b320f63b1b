// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {

/// The log odds of success of a grasp whose terms are all zero.
inline constexpr double kSuccessBias = -10.91;

/// The weights of the GraspTerms in the log odds of success, in the order of GraspTerms::visit().
inline constexpr std::array kSuccessWeights = {
    1.106,   // friction
    0.5000,  // clearance
    0.6828,  // room
    0.5701,  // central
    3.906,   // seen
    3.932,   // confidence
    -1.562,  // range
    1.782,   // rim
    0.4826,  // shape
    1.636,   // inner
    1.924,   // height
};

}  // namespace quadrille

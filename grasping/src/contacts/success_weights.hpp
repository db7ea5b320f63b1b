// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {

/// The log odds of success of a grasp whose terms are all zero.
inline constexpr double kSuccessBias = -8.339;

/// The weights of the GraspTerms in the log odds of success, in the order of GraspTerms::visit().
inline constexpr std::array kSuccessWeights = {
    1.170,   // friction
    0.5000,  // clearance
    0.5000,  // room
    0.5041,  // central
    3.476,   // seen
    3.086,   // confidence
    -2.422,  // range
    0.9023,  // rim
    0.9708,  // shape
    1.034,   // inner
    1.552,   // height
};

}  // namespace quadrille

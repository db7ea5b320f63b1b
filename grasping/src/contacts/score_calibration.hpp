// Written by tools/lab/grasps/calibration.py.
#pragma once

namespace quadrille {

/// The log odds of success of a grasp are this slope times those that the weights give, plus this
/// offset. Since the slope is positive, the order of grasps is that of the weights.
inline constexpr double kCalibrationSlope = 1.28, kCalibrationOffset = 0.43;

}  // namespace quadrille

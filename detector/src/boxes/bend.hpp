#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxes/face.hpp"

namespace quadrille {

/// The normal of a face turns across it by no more than this [rad]. Worn boxes bulge; the strip of
/// a cylinder that passes for a plane turns by .7 or more.
inline constexpr double kMaxTurn = 0.5;

/// How a face bends, by a quadratic fit to its points as they were measured.
struct Bend {
  /// How far the normal turns across the face [rad]: nearly 0 on a flat one, about 1 on the strip
  /// of a cylinder that is thin enough to pass for a plane. Infinite if there are no points.
  double turn = 0.0;
  /// How far the face bulges beyond its plane, 0 for dents, and the standard deviation of that [m].
  double bulge = 0.0, bulge_std = 0.0;
};

/// The mean height of the points of a paraboloid h = -x'Kx / 2 is -tr(KS) / 2, where S is the
/// covariance of their places. So its vertex lies tr(KS) / 2 above the plane of the points.
Bend bend_of(const Face& face, const std::vector<Eigen::Vector3d>& measured_C);

}  // namespace quadrille

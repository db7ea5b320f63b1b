#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// The seen part of a quadric as oriented points spread evenly over it. It is where its points
/// were, regardless of the quadric's type and of its canonical origin.
struct SeenPatch {
  /// The quadric in the fixed frame W.
  Quadric Q_W;
  /// Transforms points from W to the canonical frame, in which the extent is given.
  Eigen::Isometry3d X_QW = Eigen::Isometry3d::Identity();
  Eigen::AlignedBox3d extent_Q;
  /// Points [m] and unit gradients there; never empty.
  std::vector<Eigen::Vector3d> points_W, normals_W;
  Eigen::Vector3d centre_W = Eigen::Vector3d::Zero();
  /// Twice the root mean square distance of the points from their centre [m]; at least a
  /// micrometre, to divide by.
  double size = 1e-6;
  /// The detection's rms [m].
  double rms = 0.0;
};

/// Fits of two views differ by this share of the patch's size, in addition to the noise.
inline constexpr double kFitShare = 0.03;

/// Standard deviation of a patch's position along its normals [m]. It does not fall with the number
/// of points, since the sensor's own error changes with the view.
double place_std(const SeenPatch& patch);

/// Makes the patch of a detection.
/// @param X_WC  pose of the detection's frame in the fixed frame
SeenPatch seen_patch(const Detection& detection, const Eigen::Isometry3d& X_WC);

/// Returns the patch after a translation [m].
SeenPatch translated(SeenPatch patch, const Eigen::Vector3d& shift_W);

/// Result of carrying one patch onto another.
struct PatchMatch {
  /// The shortest translation that does so [m]. It has no part along directions in which the
  /// surfaces slide, such as within a plane or along a cylinder's axis, since motion there cannot
  /// be seen.
  Eigen::Vector3d shift_W = Eigen::Vector3d::Zero();
  /// Root mean square distance of the surfaces after the shift, where both were seen [m].
  double residual = 0.0;
  /// Root mean square sine of the angle between their normals there, 0 to 1; 1 if they point apart.
  double turn = 0.0;
  /// Mean distance of one patch's points beyond the extent of the other, the smaller of both
  /// directions [m]; 0 if one patch was seen within the other.
  double gap = 0.0;
  /// Share of the points of both patches that lie within the extent of the other, 0 to 1.
  double overlap = 0.0;
};

/// Carries one patch onto another by Gauss-Newton steps on the distances of each patch's points to
/// the other's quadric.
PatchMatch match_patches(const SeenPatch& from, const SeenPatch& to);

}  // namespace quadrille

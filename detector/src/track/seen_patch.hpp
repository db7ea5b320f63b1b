#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// What was seen of a quadric, as oriented points spread evenly over it: whatever the quadric is
/// named and wherever its canonical origin lies, the patch is where its points were.
struct SeenPatch {
  /// The quadric in the fixed frame W.
  Quadric Q_W;
  /// Carries points of W into the canonical frame, in which the extent is given.
  Eigen::Isometry3d X_QW = Eigen::Isometry3d::Identity();
  Eigen::AlignedBox3d extent_Q;
  /// Points [m] and unit gradients there. Never empty.
  std::vector<Eigen::Vector3d> points_W, normals_W;
  Eigen::Vector3d centre_W = Eigen::Vector3d::Zero();
  /// Root mean square distance of the points from their centre, twice [m].
  double size = 0.0;
  /// That of the detection [m].
  double rms = 0.0;
};

/// Where the line o + t d crosses a quadric, as values of t, none, one or two. Where it touches it
/// and stays on one side, or lies in it, it crosses nothing.
std::vector<double> crossings(const Quadric& Q, const Eigen::Vector3d& o, const Eigen::Vector3d& d);

/// The patch of a detection.
/// @param X_WC  pose of the detection's frame in the fixed one
SeenPatch seen_patch(const Detection& detection, const Eigen::Isometry3d& X_WC);

/// The patch after a translation [m].
SeenPatch translated(SeenPatch patch, const Eigen::Vector3d& shift_W);

/// How one patch can be carried onto another.
struct PatchMatch {
  /// The shortest translation that does: none along directions in which the surfaces slide, such as
  /// a plane in itself or a cylinder along its axis, for there it cannot be told [m].
  Eigen::Vector3d shift_W = Eigen::Vector3d::Zero();
  /// Root mean square distance of the surfaces after it, where both were seen [m].
  double residual = 0.0;
  /// Root mean square sine of the angle of their normals there, 0 to 1; 1 if they point apart.
  double turn = 0.0;
  /// How far on average the points of one patch lie beyond the extent of the other, the lesser of
  /// both ways: 0 if one patch was seen within the other [m].
  double gap = 0.0;
  /// Share of the points of both patches that lie within the extent of the other, 0 to 1.
  double overlap = 0.0;
};

/// Carries one patch onto another by Gauss-Newton steps on the distances of each one's points to
/// the other's quadric.
PatchMatch match_patches(const SeenPatch& from, const SeenPatch& to);

}  // namespace quadrille

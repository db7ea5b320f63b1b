#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "boxes/direction_index.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Edges of boxes are rounded within this distance [m]. Thinner things are sheets, or steps that
/// noise feigns.
inline constexpr double kRounding = 0.008;
/// Normals are parallel or at right angles if they are within this angle (9°): sensors bend faces
/// in waves, and beyond it a right angle cannot be told from others.
inline constexpr double kMaxSkew = 0.15;
/// Points count as part of a face if they lie within three standard deviations of its plane, but at
/// most this far from it [m]. A detection's extent ends short of the plane's edges by up to as
/// much.
inline constexpr double kMaxTolerance = 0.015;
/// Points no farther apart than this many pitches lie side by side.
inline constexpr double kGapPitches = 2.5;
/// Least cosine between a line of sight and a normal at which a face is looked at and pitches are
/// stretched.
inline constexpr double kMinCosine = 0.1;
/// Share of a face's points that is left out at either end of its range, since some points may be
/// those of a neighbour.
inline constexpr double kTrimmed = 0.01;
/// So many neighbouring points share their noise and count as one measurement.
inline constexpr double kSharedNoise = 16.0;
/// Distance around an edge within which its surroundings are looked at [m].
inline constexpr double kAround = 0.02;

/// Unit normal of a plane on the side that the sensor saw.
Eigen::Vector3d outward_normal(const Detection& plane);

/// A connected piece of a plane in the cloud, which may be a side of a box. Faces are sought in
/// patches, rectangles that tell where and how a face may lie (FacePatch).
struct Face {
  /// Id and confidence of the plane's detection; 0 if it was not detected.
  int id = 0;
  double score = 0.0;
  /// True if the face was sought in a flat patch among other samples, not at a detected plane.
  bool is_patch = false;
  /// Outward unit normal, and offset of the plane n·x = offset [m].
  Eigen::Vector3d n_C = Eigen::Vector3d::UnitZ();
  double offset = 0.0;
  /// Noise of the points along the normal [m].
  double sigma = 0.0;
  /// How far the face bulges beyond its plane, and the standard deviation of that [m].
  double bulge = 0.0, bulge_std = 0.0;
  /// Cosine between the normal and the line of sight: the factor from noise along that line to
  /// noise along the normal.
  double cosine = 1.0;
  /// Distance between neighbouring points across the line of sight [m].
  double pitch = 0.0;
  /// The points, moved along their lines of sight onto the plane, so that noise along these lines
  /// does not blur the face's outline.
  std::vector<Eigen::Vector3d> points_C;
  /// Middle of the points, and the largest distance of a point from it [m].
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero();
  double radius = 0.0;

  /// Number of independent measurements among the points.
  double measurements() const { return static_cast<double>(points_C.size()) / kSharedNoise; }
  double height(const Eigen::Vector3d& p_C) const { return n_C.dot(p_C) - offset; }
  /// Sets middle_C and radius from the points.
  void set_middle();
  /// Points count as part of the face if they lie no farther than this from the plane [m].
  double tolerance() const;
  /// Distance between neighbouring points along a unit direction u in the plane [m].
  double pitch_along(const Eigen::Vector3d& u_C, const DirectionIndex& sight) const;
  /// Range of the points along a unit direction, without the outermost hundredth at either end [m].
  std::pair<double, double> reach(const Eigen::Vector3d& u_C) const;
};

/// A patch: a rectangle in which a face is sought, with half sizes [m] around the origin of frame P
/// and z along the outward normal.
struct FacePatch {
  Eigen::Isometry3d X_CP = Eigen::Isometry3d::Identity();
  Eigen::Vector2d half = Eigen::Vector2d::Zero();
};

/// The least-squares plane of some points and the rectangle around them.
/// @param R_CL  axes of a frame whose x and z are nearly those of the patch
FacePatch patch_around(const std::vector<Eigen::Vector3d>& points_C, const Eigen::Matrix3d& R_CL);

/// A flat patch of a surface that was not detected as a plane, with the noise of its points along
/// the normal [m].
struct FlatPatch {
  FacePatch patch;
  double sigma = 0.0;
  /// How far beside the patch the face may reach [m].
  double margin = kMaxTolerance;
};

}  // namespace quadrille

#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "quadrille/detector/box.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/quadric_type.hpp"

namespace quadrille {

/// One named measure of a quadric, such as "radius" [m] or "half_angle" [rad].
struct Dimension {
  std::string name;
  double value = 0.0;
  /// Standard deviation, in the unit of the value; infinite where the view does not show the
  /// dimension and its value is a guess.
  double std = 0.0;
};

/// What is known of the coefficients of a quadric of unit norm, in the order of
/// Quadric::coefficients().
struct QuadricCovariance {
  /// Covariance along the directions that the view shows.
  Eigen::Matrix<double, 10, 10> known = Eigen::Matrix<double, 10, 10>::Zero();
  /// Orthonormal columns: the directions that it leaves open, along which q may lie anywhere.
  Eigen::Matrix<double, 10, Eigen::Dynamic> open = Eigen::Matrix<double, 10, Eigen::Dynamic>(10, 0);
};

/// One quadric found in a cloud with frame C.
struct Detection {
  /// 1, 2, … within one result, best score first; −1, −2, … for what was found but not asked for:
  /// nothing to show or to grasp, but in the way.
  int id = 0;
  QuadricType type = QuadricType::kPlane;
  /// Of unit norm, its gradient pointing to the side that the sensor saw.
  Quadric Q_C;
  /// Of the coefficients of Q_C. Messages and files do not hold it.
  QuadricCovariance covariance;
  /// Confidence, 0 to 1.
  double score = 0.0;
  /// Cloud points that lie on the quadric with a compatible normal.
  int inliers = 0;
  /// Root mean square of the first-order distance of the inliers [m].
  double rms = 0.0;
  /// Pose of the canonical frame Q: origin at the centre (or apex, vertex, middle of the seen part
  /// of an axis), z along the axis of symmetry, or along a plane's normal towards the sensor.
  Eigen::Isometry3d X_CQ = Eigen::Isometry3d::Identity();
  /// Depends on the type:
  ///   sphere radius; ellipsoid a b c (semi-axes along x y z); cylinder radius length;
  ///   elliptic_cylinder a b length; cone half_angle; elliptic_cone half_angle_a half_angle_b;
  ///   elliptic_paraboloid and hyperbolic_paraboloid focal_a focal_b (z = x²/4fa ± y²/4fb);
  ///   hyperboloids a b c; hyperbolic_cylinder a b; parabolic_cylinder focal;
  ///   plane width height; parallel_planes distance; intersecting_planes angle.
  std::vector<Dimension> dimensions;
  /// Bounding box of the inliers in frame Q [m].
  Eigen::AlignedBox3d extent_Q;
  /// Share of the surface within the extent that was observed, 0 to 1.
  double seen = 0.0;
  /// 1, 2, …: the same for one surface in all clouds of a sequence (see Tracker); 0 where nothing
  /// was tracked.
  int track = 0;
};

/// True if a detection was asked for, by what its id says.
inline bool is_reported(const Detection& detection) { return detection.id >= 0; }

/// The rotation of a pose as messages and files hold it: a unit quaternion with w >= 0, for q and
/// -q are one rotation, and equal poses are to be written equally.
QUADRILLE_EXPORT Eigen::Quaterniond rotation_of(const Eigen::Isometry3d& X);

/// Wall time of one stage of a computation.
struct StageTime {
  std::string stage;
  double ms = 0.0;
};

/// What the detector made of one cloud.
struct DetectionResult {
  /// Best score first; those that were not asked for after all others.
  std::vector<Detection> detections;
  /// What planes among them are faces of, the surest first.
  std::vector<Box> boxes;
  /// Points with finite coordinates within kMaxRange, and those of them that surface samples were
  /// made of.
  std::size_t points_finite = 0, points_used = 0;
  /// In the order of the stages, without their total.
  std::vector<StageTime> timings;
  /// From the decoded cloud to the detections [ms].
  double total_ms = 0.0;
  /// Why the result may be empty or poor ("all points lie on a line", "coordinates look like
  /// millimetres"); empty when all is well.
  std::vector<std::string> warnings;
};

}  // namespace quadrille

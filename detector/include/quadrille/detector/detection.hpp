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
  /// Standard deviation in the unit of the value; infinite if the view does not show the dimension
  /// and its value is a guess.
  double std = 0.0;
};

/// Uncertainty of the coefficients of a quadric of unit norm, in the order of
/// Quadric::coefficients().
struct QuadricCovariance {
  /// Covariance along the directions in coefficient space that the view determines.
  Eigen::Matrix<double, 10, 10> known = Eigen::Matrix<double, 10, 10>::Zero();
  /// Orthonormal columns: the directions that the view leaves undetermined, along which q may lie
  /// anywhere.
  Eigen::Matrix<double, 10, Eigen::Dynamic> open = Eigen::Matrix<double, 10, Eigen::Dynamic>(10, 0);
};

/// One quadric found in a cloud with frame C.
struct Detection {
  /// Ids are 1, 2, … within one result, best score first. Ids −1, −2, … mark detections that were
  /// found but not asked for: they are not shown and not grasped, but are obstacles.
  int id = 0;
  QuadricType type = QuadricType::kPlane;
  /// The quadric, of unit norm, with its gradient towards the side that the sensor saw.
  Quadric Q_C;
  /// Covariance of the coefficients of Q_C. Messages and files do not contain it.
  QuadricCovariance covariance;
  /// Confidence, 0 to 1.
  double score = 0.0;
  /// Number of cloud points that lie on the quadric with a compatible normal.
  int inliers = 0;
  /// Root mean square of the first-order distance of the inliers [m].
  double rms = 0.0;
  /// Pose of the canonical frame Q. The origin is the centre, apex or vertex, or the middle of the
  /// seen part of an axis; z runs along the axis of symmetry, or along a plane's normal towards the
  /// sensor.
  Eigen::Isometry3d X_CQ = Eigen::Isometry3d::Identity();
  /// Dimensions by type:
  ///   sphere radius; ellipsoid a b c (semi-axes along x y z); cylinder radius length;
  ///   elliptic_cylinder a b length; cone half_angle; elliptic_cone half_angle_a half_angle_b;
  ///   elliptic_paraboloid and hyperbolic_paraboloid focal_a focal_b (z = x²/4fa ± y²/4fb);
  ///   hyperboloids a b c; hyperbolic_cylinder a b; parabolic_cylinder focal;
  ///   plane width height; parallel_planes distance; intersecting_planes angle.
  std::vector<Dimension> dimensions;
  /// Value of the n-th dimension; 0 if there are fewer.
  double dimension(std::size_t n) const {
    return n < dimensions.size() ? dimensions[n].value : 0.0;
  }
  /// Bounding box of the inliers in frame Q [m].
  Eigen::AlignedBox3d extent_Q;
  /// Share of the surface within the extent that was observed, 0 to 1.
  double seen = 0.0;
  /// Number of the surface, 1, 2, …, which it keeps in all clouds of a sequence (see Tracker); 0 if
  /// it was not tracked.
  int track = 0;
};

/// True if a detection was asked for, which its id tells.
inline bool is_reported(const Detection& detection) { return detection.id >= 0; }

/// The rotation of a pose as stored in messages and files: the unit quaternion with w >= 0. Since q
/// and -q are the same rotation, this writes equal poses equally.
QUADRILLE_EXPORT Eigen::Quaterniond rotation_of(const Eigen::Isometry3d& X);

/// Wall time of one stage of a computation.
struct StageTime {
  std::string stage;
  double ms = 0.0;
};

/// The result of detection on one cloud.
struct DetectionResult {
  /// Detections, best score first; those that were not asked for come last.
  std::vector<Detection> detections;
  /// Boxes whose faces are planes among the detections, the most certain first.
  std::vector<Box> boxes;
  /// Number of finite points within kMaxRange, and of those among them that went into surface
  /// samples.
  std::size_t points_finite = 0, points_used = 0;
  /// Times of the stages in their order, without the total.
  std::vector<StageTime> timings;
  /// Time from the decoded cloud to the detections [ms].
  double total_ms = 0.0;
  /// Reasons why the result may be empty or poor, such as "all points lie on a line" or
  /// "coordinates look like millimetres"; empty if there are none.
  std::vector<std::string> warnings;
};

}  // namespace quadrille

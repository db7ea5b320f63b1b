#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "quadrille/detector/body.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// A box of which one, two or three faces were seen.
struct Box {
  /// Number of the box, which continues the ids of the detections.
  int id = 0;
  /// Ids of the detections that are faces of the box, those with more points first.
  std::vector<int> faces;
  /// Mean confidence of the detected faces, 0 to 1; one half if none was detected.
  double score = 0.0;
  /// Pose of frame B: the origin is the middle of the box, the longest side runs along x and the
  /// shortest along z; x and z point to the sensor's side.
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();
  /// Lengths of the sides along x, y, z, and their standard deviations [m]. For a side that was not
  /// seen, they are its most likely length and the deviation of a length uniform between its
  /// bounds.
  Eigen::Vector3d size = Eigen::Vector3d::Zero(), std = Eigen::Vector3d::Zero();
  /// True if both ends of the side were seen.
  std::array<bool, 3> seen = {false, false, false};
  /// The part that was seen, and the most that the box may occupy without hiding what was seen
  /// behind it or crossing a plane, in frame B [m]. They differ at ends that are not seen in full.
  Eigen::AlignedBox3d inner_B, outer_B;
};

/// False if the box was found but not asked for, like its faces; it then only is an obstacle.
inline bool is_reported(const Box& box) { return box.faces.empty() || box.faces.front() >= 0; }

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

/// The rotation of a pose as stored in messages and files: the unit quaternion with w >= 0, since q
/// and -q are the same rotation. It is rounded so that its components, divided by the largest of
/// them, are multiples of 2⁻⁴⁴, which turns it by less than 1e-12 rad. So a pose that is made of
/// this quaternion is written with the same one again, to the last bit.
QUADRILLE_EXPORT Eigen::Quaterniond rotation_of(const Eigen::Isometry3d& X);

/// Returns a pose as it is read from a message or file to which it was written. All results have
/// such poses, so readers get the bits that the writer has. Rounding twice changes nothing more.
QUADRILLE_EXPORT Eigen::Isometry3d rounded(const Eigen::Isometry3d& X);

/// Wall time of one stage of a computation.
struct StageTime {
  std::string stage;
  double ms = 0.0;
};

/// The result of detection on one cloud.
struct DetectionResult {
  /// Detections, best score first; those that were not asked for come last.
  std::vector<Detection> detections;
  /// Boxes with their faces among the detections, the most certain first. A box of small faces may
  /// have none of them.
  std::vector<Box> boxes;
  /// The things of the scene, to which the detections and boxes belong, in the order of their ids.
  std::vector<SceneBody> bodies;
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

/// Transforms the points and the viewpoint of a cloud from frame C to frame F; the name of the
/// frame stays. If X_FC is the identity, all bits are kept.
QUADRILLE_EXPORT PointCloud moved(PointCloud cloud, const Eigen::Isometry3d& X_FC);

/// Transforms a detection from frame C to frame F. If X_FC is the identity, all bits are kept.
QUADRILLE_EXPORT Detection moved(Detection detection, const Eigen::Isometry3d& X_FC);

/// Transforms detections from frame C to frame F.
QUADRILLE_EXPORT std::vector<Detection> moved(std::vector<Detection> detections,
                                              const Eigen::Isometry3d& X_FC);

/// Transforms boxes from frame C to frame F.
QUADRILLE_EXPORT std::vector<Box> moved(std::vector<Box> boxes, const Eigen::Isometry3d& X_FC);

/// True if the sensor saw the inside of a round surface, such as the inner wall of a mug; false for
/// types without an inside.
QUADRILLE_EXPORT bool shows_inside(const Detection& detection);

}  // namespace quadrille

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "process/runtime/poses/cloud_frame.hpp"
#include "process/runtime/poses/pose_history.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Why the pose of a cloud's camera is not known.
enum class PoseLack {
  kNoPose,    ///< no pose has come, or only newer ones
  kOldPose,   ///< the pose before the cloud, or the one after it, is too far from it in time
  kLatePose,  ///< no pose after the cloud has come in time
};

/// The camera's pose in W when it took a cloud, or why that is not known.
struct CameraPose {
  std::optional<Eigen::Isometry3d> X_WK = {};
  /// Time between the cloud and the nearer of the two poses around it, or the newest pose if the
  /// cloud is not between two [s]; nullopt if there is none.
  std::optional<double> age = {};
  /// Motion of the camera between these two poses or the newest ones; 0 if it is not known.
  Motion motion = {};
  PoseLack lack = PoseLack::kNoPose;
  /// The problem and its remedy, for the log; empty if the pose is known.
  std::string detail = {};
};

/// The poses of one camera, in the order in which they come.
class CameraPoses {
 public:
  /// @param max_age  longest time between a cloud and each of the two poses around it [s]
  /// @param max_wait  how long a cloud waits for poses, for messages about clouds without one [s]
  CameraPoses(double max_age, double max_wait);

  void add(const bus::PoseMessage& pose) { history_.add(pose); }

  /// Returns the pose for a cloud taken at this time [us], interpolated between the last pose at or
  /// before it and the first one after it, if both are near enough. A pose of exactly that time is
  /// used as it is.
  CameraPose at(std::int64_t utime) const;

  /// Explains why a cloud has no pose, and what to do about it.
  std::string explain(std::int64_t utime, const CameraPose& none) const;

 private:
  Motion newest_motion() const;

  double max_age_, max_wait_;
  PoseHistory history_;
};

/// Describes how far objects may be misplaced if the poses are far in time from a cloud of a moving
/// camera. Empty if they are near, or the camera hardly moves.
std::string describe_if_far(const CameraPose& pose);

/// Poses of a cloud and of its results; the work is done in frame K, the camera's.
struct Placement {
  /// Pose of frame K in the cloud's frame C and in the frame R of the results.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity(), X_RK = Eigen::Isometry3d::Identity();
  /// Pose of frame K in the fixed frame, if the camera's pose is known.
  std::optional<Eigen::Isometry3d> X_WK;
  /// Name of R if it differs from C; otherwise empty.
  std::string frame;
  /// Why the camera's pose, although needed, is not known; empty if nothing is missing.
  std::string lack;

  /// Returns the name of the frame of the results.
  /// @param cloud_frame  name of C
  const std::string& frame_of_results(const std::string& cloud_frame) const {
    return frame.empty() ? cloud_frame : frame;
  }
};

/// Returns the placement of a cloud whose camera had this pose.
Placement place(const CloudFrames& frames, const CameraPose& pose);

/// Returns a cloud in frame K, in which the sensor of a cloud given in W is the origin.
PointCloud in_camera_frame(const PointCloud& cloud, const Placement& placement,
                           const CloudFrames& frames);

}  // namespace quadrille

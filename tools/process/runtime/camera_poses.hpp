#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "process/runtime/cloud_frame.hpp"
#include "process/runtime/pose_history.hpp"

namespace quadrille {

/// Why a cloud has no pose of its camera.
enum class PoseLack {
  kNoPose,    ///< none has come, or only newer ones
  kOldPose,   ///< the one before the cloud, or the one after it, lies too far from it
  kLatePose,  ///< none after the cloud has come in time
};

/// Where the camera stood when it took a cloud: its pose in W, or why that is not known.
struct CameraPose {
  std::optional<Eigen::Isometry3d> X_WK = {};
  /// Time between the cloud and the nearest of the two poses about it, or the newest pose if it is
  /// not between two [s]; nullopt if there is none.
  std::optional<double> age = {};
  /// How the camera moves, by these two poses or the newest ones; 0 if that is not known.
  Motion motion = {};
  PoseLack lack = PoseLack::kNoPose;
  /// What is wrong and what to do, for the log; empty if the pose is known.
  std::string detail = {};
};

/// The poses of one camera, as they come.
class CameraPoses {
 public:
  /// @param max_age   longest time between a cloud and each of the two poses about it [s]
  /// @param max_wait  how long a cloud waits for them, as is told of one that has none [s]
  CameraPoses(double max_age, double max_wait);

  void add(const bus::PoseMessage& pose) { history_.add(pose); }

  /// The pose for a cloud of that time [us]: between the last pose at or before it and the first
  /// after it, if both are near enough. One of exactly that time is taken as it is.
  CameraPose at(std::int64_t utime) const;

  /// What is wrong with the poses for a cloud that has none, and what to do.
  std::string explain(std::int64_t utime, const CameraPose& none) const;

 private:
  Motion newest_motion() const;

  double max_age_, max_wait_;
  PoseHistory history_;
};

/// Tells of poses that lie far from a cloud of a moving camera: how far things may be misplaced.
/// Empty if they are near, or the camera hardly moves.
std::string describe_if_far(const CameraPose& pose);

/// How a cloud lies, and its results: work is done in frame K, the camera's.
struct Placement {
  /// Frame K in the cloud's frame C and in the frame R of the results.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity(), X_RK = Eigen::Isometry3d::Identity();
  /// Frame K in the fixed frame, where the camera's pose is known.
  std::optional<Eigen::Isometry3d> X_WK;
  /// Name of R where it is not C; else empty.
  std::string frame;
  /// Why the camera's pose, which is needed, is not known; empty if all is.
  std::string lack;

  /// Name of the frame of the results.
  /// @param cloud_frame  name of C
  const std::string& frame_of_results(const std::string& cloud_frame) const {
    return frame.empty() ? cloud_frame : frame;
  }
};

/// How a cloud lies whose camera had this pose.
Placement place(const CloudFrames& frames, const CameraPose& pose);

}  // namespace quadrille

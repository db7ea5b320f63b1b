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
  kNoPose,   ///< none has come, or only newer ones
  kOldPose,  ///< the newest is too old
};

/// Where the camera stood when it took a cloud: its pose in W, or why that is not known.
struct CameraPose {
  std::optional<Eigen::Isometry3d> X_WK;
  PoseLack lack = PoseLack::kNoPose;
  /// What is wrong and what to do, for the log; empty if the pose is known.
  std::string detail;
};

/// The poses of one camera, as they come.
class CameraPoses {
 public:
  /// @param fixed    the pose of a camera that stands still; none: they come
  /// @param max_age  of the newest pose, before it tells nothing of a cloud [s]
  CameraPoses(std::optional<Eigen::Isometry3d> fixed, double max_age)
      : fixed_(std::move(fixed)), max_age_(max_age) {}

  void add(const bus::PoseMessage& pose) { history_.add(pose); }

  /// The pose for a cloud of that time [us]: the newest that is not newer than it.
  CameraPose at(std::int64_t utime) const;

 private:
  std::optional<Eigen::Isometry3d> fixed_;
  double max_age_;
  PoseHistory history_;
};

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

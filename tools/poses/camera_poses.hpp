#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "poses/pose_history.hpp"

namespace quadrille {

/// Why the pose of a cloud's camera is not known.
enum class PoseLack {
  kNoPose,    ///< no pose has come, or only newer ones
  kOldPose,   ///< the pose before the cloud, or the one after it, is too far from it in time
  kLatePose,  ///< no pose after the cloud has come in time
  kJump,      ///< the poses have jumped; see have_jumped()
};

/// Names of these reasons in messages, in the same order.
inline constexpr std::array kPoseLackNames = {"no_pose", "old_pose", "late_pose", "jump"};

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
  /// used as it is. There is none if the poses have jumped.
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

}  // namespace quadrille

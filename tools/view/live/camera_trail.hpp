#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>

#include "poses/camera_poses.hpp"

namespace quadrille::view {

/// Where a camera is and was in the fixed frame W, from the messages with its poses.
class CameraTrail {
 public:
  /// Limit of the positions of the path.
  static constexpr std::size_t kMaxPath = 300;
  /// Least distance between two positions of the path [m]. So its length does not depend on the
  /// rate of the poses, and a camera at rest does not fill it.
  static constexpr double kStep = 0.005;

  CameraTrail();

  /// Adds a pose from a message; a damaged one is left out.
  void add(std::span<const std::byte> bytes);

  /// Returns the pose X_WK of the camera at a time [us], between the two poses around it, or else
  /// the newest pose if that is near enough; nullopt if neither is.
  std::optional<Eigen::Isometry3d> at(std::int64_t utime) const;
  /// Explains why there is no pose for a time [us].
  std::string explain(std::int64_t utime) const;
  /// The last positions in W, oldest first [m].
  const std::deque<Eigen::Vector3d>& path() const { return path_; }

 private:
  CameraPoses poses_;
  /// The pose that came last.
  std::optional<bus::PoseMessage> last_;
  std::deque<Eigen::Vector3d> path_;
};

}  // namespace quadrille::view

#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "logs/cloud_log_writer.hpp"

namespace quadrille::logs {

/// Writes the clouds of a moving camera as an LCM log, with the camera's poses at 100 Hz around
/// them in the order of their times: the first pose is 5 ms before the first cloud, and the last
/// one at most 10 ms after the last cloud.
class PosedLogWriter {
 public:
  /// Returns the camera's pose X_WK at a time after the first cloud, or before it [s].
  using PoseAt = std::function<Eigen::Isometry3d(double time)>;

  /// Highest rate of clouds [Hz], so that the first pose has a time of at least 0, and each cloud
  /// has poses of its own.
  static constexpr double kMaxRate = 100.0;

  /// @param name  name of the log in errors; if empty, the path
  /// @throws std::invalid_argument if an option is out of range, or the rate above kMaxRate
  /// @throws std::runtime_error if the file cannot be made
  PosedLogWriter(const std::string& path, const CloudLogOptions& options, std::string pose_channel,
                 PoseAt pose_at, const std::string& name = "");

  /// Appends a cloud, after the poses up to its time.
  /// @throws as CloudLogWriter does
  void write(const PointCloud& cloud);

  /// Time of the next cloud [us].
  std::int64_t next_utime() const { return options_.utime_of(clouds_.clouds() + 1); }

  /// Appends a message that is to come at the time of the next cloud, before it.
  /// @throws std::runtime_error if it cannot be written
  void write_before(const std::string& channel, std::span<const std::byte> bytes);

  /// Appends the pose after the last cloud, and passes everything to the operating system.
  /// @throws std::runtime_error if that fails
  void finish();

  /// Number of bytes of messages written so far.
  std::int64_t bytes() const { return clouds_.bytes(); }

 private:
  void write_pose();
  void write_poses_until_next();

  CloudLogOptions options_;
  std::string pose_channel_;
  PoseAt pose_at_;
  CloudLogWriter clouds_;
  /// Time of the next pose [us].
  std::int64_t utime_;
};

}  // namespace quadrille::logs

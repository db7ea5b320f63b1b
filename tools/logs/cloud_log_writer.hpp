#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "log/event_log.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/pose_message.hpp"

namespace quadrille::logs {

/// Limits of the rate of a log [Hz].
inline constexpr double kMinRate = 0.001, kMaxRate = 10000;

/// How clouds are written to a log.
struct CloudLogOptions {
  /// Rate of clouds in the log's own time [Hz].
  double rate = 10.0;
  std::string channel = "POINT_CLOUD";
  bus::CloudFormat format = bus::CloudFormat::kDrake;

  /// Returns the time n / rate of the n-th cloud, counted from 1 [us].
  std::int64_t utime_of(std::int64_t n) const;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

/// Writes clouds as an LCM log that lcm-logplayer and file:// play.
class CloudLogWriter {
 public:
  /// @param name  name of the log in errors; if empty, the path
  /// @throws std::invalid_argument if an option is out of range
  /// @throws std::runtime_error if the file cannot be made
  CloudLogWriter(const std::string& path, const CloudLogOptions& options,
                 const std::string& name = "");

  /// Appends a cloud; the n-th one, counted from 1, gets utime_of(n) and seq n - 1.
  /// @throws std::invalid_argument if the cloud does not fit into a message
  /// @throws std::runtime_error if it cannot be written
  void write(const PointCloud& cloud);

  /// Appends a pose at its own time.
  /// @throws std::runtime_error if it cannot be written
  void write(const bus::PoseMessage& pose, const std::string& channel);

  /// Appends any message at a time [us].
  /// @throws std::runtime_error if it cannot be written
  void write(std::int64_t utime, const std::string& channel, std::span<const std::byte> bytes);

  /// Passes everything written so far to the operating system.
  /// @throws std::runtime_error if that fails
  void flush() { log_.flush(); }

  /// Number of clouds, and bytes of messages, written so far.
  std::int64_t clouds() const { return clouds_; }
  std::int64_t bytes() const { return bytes_; }

 private:
  CloudLogOptions options_;
  bus::LogWriter log_;
  std::int64_t clouds_ = 0, bytes_ = 0;
};

}  // namespace quadrille::logs

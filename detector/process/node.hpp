#pragma once

#include <chrono>
#include <cstdint>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/durations.hpp"
#include "quadrille/bus/publish.hpp"
#include "quadrille/bus/rate_limiter.hpp"
#include "quadrille/bus/rejection.hpp"
#include "settings.hpp"

namespace quadrille {

/// A cloud on its way to the detector.
struct ReceivedCloud {
  bus::CloudMessage message;
  std::chrono::steady_clock::time_point at;
};

/// The work of the process, the same on the bus and in replay.
class DetectorNode {
 public:
  DetectorNode(const DetectorSettings& settings, bus::Publish publish);

  /// Decodes a message of the input channel; nullopt if it was refused, which is counted and
  /// logged. For the receiving thread.
  std::optional<ReceivedCloud> receive(std::span<const std::byte> bytes);

  /// Detects and publishes; what fails is counted and logged. For the working thread.
  void handle(const ReceivedCloud& cloud);

  /// Publishes the status.
  /// @param superseded  clouds dropped for a newer one
  /// @param warnings    what is wrong with the transport
  void publish_status(std::int64_t superseded, const std::vector<std::string>& warnings);

  /// Clouds on which the detection failed.
  std::int64_t failed() const;

 private:
  void log_rejection(const bus::Rejection& rejection);
  void detect_and_publish(const ReceivedCloud& cloud);
  detector_status_t make_status() const;

  const DetectorSettings settings_;
  const bus::Publish publish_;
  const std::int64_t dropped_before_;
  bus::RateLimiter rejection_log_{std::chrono::seconds(1)};

  mutable std::mutex mutex_;
  detector_status_t counts_{};
  bus::RejectCounts rejected_;
  bus::Durations latencies_, detections_;
};

}  // namespace quadrille

#pragma once

#include <chrono>
#include <cstdint>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "process/node.hpp"
#include "process/refusals.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/durations.hpp"
#include "settings.hpp"

namespace quadrille {

/// Finds the quadrics of the clouds of one channel.
class DetectorNode : public Node {
 public:
  DetectorNode(const DetectorSettings& settings, bus::Publish publish);

  std::vector<InChannel> in_channels() const override;
  std::optional<Job> receive(const std::string& channel, std::span<const std::byte> bytes) override;
  void publish_status(std::int64_t superseded, const std::vector<std::string>& warnings) override;
  std::string summary() const override;

 private:
  using TimePoint = std::chrono::steady_clock::time_point;

  void detect_and_publish(const bus::CloudMessage& cloud, TimePoint received);
  detector_status_t make_status() const;

  const DetectorSettings settings_;
  const bus::Publish publish_;
  const std::int64_t dropped_before_;

  mutable std::mutex mutex_;
  detector_status_t counts_{};
  std::int64_t detections_ = 0;
  Refusals refusals_;
  bus::Durations latencies_, detection_times_;
};

}  // namespace quadrille

#include "node.hpp"

#include <spdlog/spdlog.h>

#include <utility>

#include "quadrille/bus/clock.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/network.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille {

DetectorNode::DetectorNode(const DetectorSettings& settings, bus::Publish publish)
    : settings_(settings),
      publish_(std::move(publish)),
      dropped_before_(bus::count_dropped_datagrams()) {}

std::optional<ReceivedCloud> DetectorNode::receive(std::span<const std::byte> bytes) {
  const auto now = std::chrono::steady_clock::now();
  bus::Decoded<bus::CloudMessage> decoded = bus::decode_cloud(bytes);
  const std::lock_guard lock(mutex_);
  ++counts_.received;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  if (const auto* rejection = std::get_if<bus::Rejection>(&decoded)) {
    rejected_.add(rejection->reason);
    log_rejection(*rejection);
    return std::nullopt;
  }
  ++counts_.decoded;
  return ReceivedCloud{std::get<bus::CloudMessage>(std::move(decoded)), now};
}

void DetectorNode::log_rejection(const bus::Rejection& rejection) {
  const auto held_back = rejection_log_.admit();
  if (!held_back) return;
  spdlog::warn("{}: refused a message: {} ({}); {} more since the last record",
               settings_.in_channel, to_string(rejection.reason), rejection.detail, *held_back);
}

void DetectorNode::handle(const ReceivedCloud& cloud) {
  try {
    detect_and_publish(cloud);
  } catch (const std::exception& error) {
    spdlog::error("cloud {}: {}", cloud.message.utime, error.what());
    const std::lock_guard lock(mutex_);
    ++counts_.failed;
  }
}

void DetectorNode::detect_and_publish(const ReceivedCloud& cloud) {
  const DetectionResult result = detect(cloud.message.cloud, settings_.detector);
  const auto bytes = bus::encode(bus::to_message(cloud.message, result));
  publish_(settings_.out_channel, bytes);
  const double latency = bus::ms_since(cloud.at);
  spdlog::debug("cloud {}: {} of {} points, {} quadrics, {:.1f} ms", cloud.message.utime,
                result.points_used, cloud.message.cloud.read, result.detections.size(), latency);
  for (const std::string& warning : result.warnings) {
    spdlog::debug("cloud {}: {}", cloud.message.utime, warning);
  }
  const std::lock_guard lock(mutex_);
  ++counts_.published;
  counts_.published_bytes += static_cast<std::int64_t>(bytes.size());
  counts_.cloud_utime = cloud.message.utime;
  latencies_.add(latency);
  detections_.add(result.total_ms);
}

void DetectorNode::publish_status(std::int64_t superseded,
                                  const std::vector<std::string>& warnings) {
  detector_status_t status = make_status();
  status.superseded = superseded;
  status.warnings = warnings;
  status.num_warnings = static_cast<std::int32_t>(warnings.size());
  publish_(settings_.status_channel, bus::encode(status));
}

detector_status_t DetectorNode::make_status() const {
  const std::lock_guard lock(mutex_);
  detector_status_t status = counts_;
  status.utime = bus::wall_clock_utime();
  status.dropped_datagrams =
      dropped_before_ < 0 ? -1 : bus::count_dropped_datagrams() - dropped_before_;
  status.rejected = bus::to_message(rejected_);
  status.num_rejected = static_cast<std::int32_t>(status.rejected.size());
  const bus::DurationSummary latency = latencies_.summary(), detection = detections_.summary();
  status.latency_p50 = latency.p50;
  status.latency_p95 = latency.p95;
  status.latency_max = latency.max;
  status.detect_p50 = detection.p50;
  status.detect_p95 = detection.p95;
  status.detect_max = detection.max;
  return status;
}

std::int64_t DetectorNode::failed() const {
  const std::lock_guard lock(mutex_);
  return counts_.failed;
}

}  // namespace quadrille

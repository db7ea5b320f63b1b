#include "node.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <utility>

#include "process/status.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille {

DetectorNode::DetectorNode(const DetectorSettings& settings, bus::Publish publish)
    : settings_(settings),
      publish_(std::move(publish)),
      dropped_before_(bus::count_dropped_datagrams()),
      tracker_(settings.track) {}

std::vector<InChannel> DetectorNode::in_channels() const {
  std::vector<InChannel> channels = {{"--in-channel", settings_.in_channel}};
  if (!settings_.pose_channel.empty()) {
    channels.push_back({"--pose-channel", settings_.pose_channel});
  }
  return channels;
}

std::optional<Job> DetectorNode::receive(const std::string& channel,
                                         std::span<const std::byte> bytes) {
  if (channel == settings_.in_channel) return receive_cloud(channel, bytes);
  if (channel == settings_.pose_channel) receive_pose(channel, bytes);
  return std::nullopt;
}

void DetectorNode::receive_pose(const std::string& channel, std::span<const std::byte> bytes) {
  const bus::Decoded<bus::PoseMessage> decoded = bus::decode_pose(bytes);
  const std::lock_guard lock(mutex_);
  ++poses_;
  if (const auto* rejection = std::get_if<bus::Rejection>(&decoded)) {
    refusals_.add(channel, *rejection);
  } else {
    pose_history_.add(std::get<bus::PoseMessage>(decoded));
  }
}

std::optional<Job> DetectorNode::receive_cloud(const std::string& channel,
                                               std::span<const std::byte> bytes) {
  const TimePoint now = std::chrono::steady_clock::now();
  bus::Decoded<bus::CloudMessage> decoded = bus::decode_cloud(bytes);
  const std::lock_guard lock(mutex_);
  ++counts_.received;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  if (const auto* rejection = std::get_if<bus::Rejection>(&decoded)) {
    refusals_.add(channel, *rejection);
    return std::nullopt;
  }
  ++counts_.decoded;
  auto cloud = std::get<bus::CloudMessage>(std::move(decoded));
  const std::int64_t utime = cloud.utime;
  // Chosen now, and not when the work begins, by when more poses may have come than in a replay.
  std::optional<Eigen::Isometry3d> X_WC = Eigen::Isometry3d::Identity();
  if (!settings_.pose_channel.empty()) X_WC = pose_history_.at(utime);
  if (!X_WC) ++clouds_without_pose_;
  return Job{utime,
             [this, cloud = std::move(cloud), X_WC, now] { detect_and_publish(cloud, X_WC, now); }};
}

void DetectorNode::detect_and_publish(const bus::CloudMessage& cloud,
                                      const std::optional<Eigen::Isometry3d>& X_WC,
                                      TimePoint received) {
  DetectionResult result = detect(cloud.cloud, settings_.detector);
  if (X_WC) tracker_.update(cloud.utime, *X_WC, &result.detections);
  const auto bytes = bus::encode(bus::to_message(cloud, result));
  publish_(settings_.out_channel, bytes);
  const double latency = bus::ms_since(received);
  spdlog::debug("cloud {}: {} of {} points, {} quadrics, {:.1f} ms", cloud.utime,
                result.points_used, cloud.cloud.read, result.detections.size(), latency);
  for (const std::string& warning : result.warnings) {
    spdlog::debug("cloud {}: {}", cloud.utime, warning);
  }
  const std::lock_guard lock(mutex_);
  ++counts_.published;
  counts_.published_bytes += static_cast<std::int64_t>(bytes.size());
  counts_.cloud_utime = cloud.utime;
  detections_ += static_cast<std::int64_t>(result.detections.size());
  latencies_.add(latency);
  detection_times_.add(result.total_ms);
}

void DetectorNode::publish_status(std::int64_t superseded,
                                  const std::vector<std::string>& warnings) {
  detector_status_t status = make_status();
  set_transport(superseded, warnings, dropped_before_, &status);
  publish_(settings_.status_channel, bus::encode(status));
}

detector_status_t DetectorNode::make_status() const {
  const std::lock_guard lock(mutex_);
  detector_status_t status = counts_;
  status.failed = failed();
  status.rejected = bus::to_message(refusals_.counts());
  status.num_rejected = static_cast<std::int32_t>(status.rejected.size());
  set_latency(latencies_.summary(), &status);
  const bus::DurationSummary detection = detection_times_.summary();
  status.detect_p50 = detection.p50;
  status.detect_p95 = detection.p95;
  status.detect_max = detection.max;
  return status;
}

std::string DetectorNode::summary() const {
  const std::lock_guard lock(mutex_);
  const std::string poses =
      settings_.pose_channel.empty() ? "" : fmt::format("poses in: {}, ", poses_);
  return fmt::format("clouds in: {}, {}{}; quadrics out: {}", counts_.received, poses,
                     describe(refusals_.counts()), detections_);
}

std::vector<std::string> DetectorNode::find_oddities() const {
  const std::lock_guard lock(mutex_);
  if (poses_ == 0 || clouds_without_pose_ == 0) return {};
  return {fmt::format("{} of {} clouds are older than all poses before them and were not tracked",
                      clouds_without_pose_, counts_.decoded)};
}

}  // namespace quadrille

#include "process/detector/node.hpp"

#include <fmt/format.h>

#include <utility>

#include "process/runtime/logging.hpp"
#include "process/runtime/status.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/rigid_motion.hpp"

namespace quadrille {

DetectorNode::DetectorNode(const DetectorSettings& settings, bus::Publish publish)
    : settings_(settings),
      publish_(std::move(publish)),
      dropped_before_(bus::count_dropped_datagrams()),
      tracker_(settings.track),
      camera_poses_(settings.X_WK, settings.track.pose_age),
      untracked_(settings.frames.clouds == CloudFrame::kCamera) {
  for (const std::string& warning : settings.warnings) log_warning(warning);
}

std::vector<InChannel> DetectorNode::in_channels() const {
  std::vector<InChannel> channels = {{"--in-channel", settings_.in_channel}};
  if (!settings_.pose_channel.empty()) {
    channels.push_back({"--pose-channel", settings_.pose_channel});
  }
  return channels;
}

std::vector<OutChannel> DetectorNode::out_channels() const {
  return {{"--out-channel", settings_.out_channel},
          {"--boxes-channel", settings_.boxes_channel},
          {"--status-channel", settings_.status_channel}};
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
    camera_poses_.add(std::get<bus::PoseMessage>(decoded));
  }
}

std::optional<Job> DetectorNode::receive_cloud(const std::string& channel,
                                               std::span<const std::byte> bytes) {
  if (!settings_.shard.takes(bytes)) return std::nullopt;
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
  const CameraPose pose = choose_pose(utime);
  return Job{utime,
             [this, cloud = std::move(cloud), pose, now] { detect_and_publish(cloud, pose, now); }};
}

/// The camera's pose in the fixed frame for a cloud, which is that frame where nobody tells poses;
/// if it is wanted and none is fresh enough that is counted and logged.
CameraPose DetectorNode::choose_pose(std::int64_t utime) {
  const std::string& channel = settings_.pose_channel;
  const bool wanted = settings_.track.enabled || settings_.frames.need_pose();
  if ((channel.empty() && !settings_.X_WK) || !wanted) {
    return {Eigen::Isometry3d::Identity(), {}, {}};
  }
  CameraPose pose = camera_poses_.at(utime);
  if (!pose.X_WK) untracked_.add(channel, utime, pose.lack, pose.detail);
  return pose;
}

/// What is found in a cloud, with tracks, in the frame of the results. Nothing where the pose that
/// they need is not known.
DetectionResult DetectorNode::detect_placed(const bus::CloudMessage& cloud, const CameraPose& pose,
                                            const Placement& placement) {
  if (!placement.lack.empty()) {
    DetectionResult nothing;
    nothing.warnings = {"the camera's pose is not known: " + placement.lack};
    return nothing;
  }
  PointCloud cloud_K = moved(cloud.cloud, placement.X_CK.inverse());
  if (settings_.frames.clouds == CloudFrame::kWorld) cloud_K.viewpoint.setZero();
  DetectionResult result = detect(cloud_K, settings_.detector);
  if (pose.X_WK) tracker_.update(cloud.utime, *pose.X_WK, &result.detections);
  result.detections = moved(std::move(result.detections), placement.X_RK);
  result.boxes = moved(std::move(result.boxes), placement.X_RK);
  return result;
}

void DetectorNode::detect_and_publish(const bus::CloudMessage& cloud, const CameraPose& pose,
                                      TimePoint received) {
  const Placement placement = place(settings_.frames, pose);
  const DetectionResult result = detect_placed(cloud, pose, placement);
  quadrics_t message = bus::to_message(cloud, result);
  message.frame = placement.frame_of_results(cloud.cloud.frame);
  const auto bytes = bus::encode(message);
  publish_(settings_.out_channel, bytes);
  const double latency = bus::ms_since(received);
  boxes_t boxes_message = bus::to_message(cloud, result.boxes);
  boxes_message.frame = message.frame;
  const auto boxes = bus::encode(boxes_message);
  publish_(settings_.boxes_channel, boxes);
  log_debug(fmt::format("cloud {}: {} of {} points, {} quadrics, {} boxes, {:.1f} ms", cloud.utime,
                        result.points_used, cloud.cloud.read, result.detections.size(),
                        result.boxes.size(), latency));
  for (const std::string& warning : result.warnings) {
    log_debug(fmt::format("cloud {}: {}", cloud.utime, warning));
  }
  const std::lock_guard lock(mutex_);
  ++counts_.published;
  counts_.published_bytes += static_cast<std::int64_t>(bytes.size() + boxes.size());
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
  status.untracked = untracked_.to_message();
  status.num_untracked = static_cast<std::int32_t>(status.untracked.size());
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
  // A channel without a message is told of with the others.
  if (poses_ == 0 || untracked_.total() == 0) return {};
  return {
      fmt::format("{} of {} clouds had no pose of at most {:g} s before them and were not tracked",
                  untracked_.total(), counts_.decoded, settings_.track.pose_age)};
}

}  // namespace quadrille

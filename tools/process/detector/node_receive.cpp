// The detector's messages: each is decoded, counted, and becomes a job if it calls for work.
#include <chrono>
#include <memory>
#include <mutex>
#include <utility>

#include "process/detector/node.hpp"
#include "process/runtime/poses/placed_cloud.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "run/clock.hpp"

namespace quadrille {

std::optional<Job> DetectorNode::receive(const std::string& channel,
                                         std::span<const std::byte> bytes) {
  if (cloud_channels_.matches(channel)) return receive_cloud(channel, bytes);
  if (channel == settings_.pose_channel) {
    const std::lock_guard lock(mutex_);
    posed_clouds_.receive_pose(bytes, &refusals_);
  }
  if (channel == settings_.robot_channel) {
    const std::lock_guard lock(mutex_);
    robot_.receive(channel, bytes, &refused_knowledge_);
  }
  if (channel == settings_.forget_channel) return receive_forget(channel, bytes);
  if (const int camera = posed_views_.camera_of(channel)) return receive_view(camera, bytes);
  const std::lock_guard lock(mutex_);
  posed_views_.receive_pose(channel, bytes, &refusals_);
  return std::nullopt;
}

std::optional<Job> DetectorNode::receive_forget(const std::string& channel,
                                                std::span<const std::byte> bytes) {
  auto decoded = bus::decode_forget(bytes);
  const std::lock_guard lock(mutex_);
  const auto message = refused_knowledge_.accept(channel, std::move(decoded));
  if (!message || !settings_.remembers()) return std::nullopt;
  return forgetting_job(
      channel, *message, [this](const forget_t& what) { forget(what); },
      [this, channel](const bus::Rejection& rejection) {
        const std::lock_guard lock(mutex_);
        refused_knowledge_.add(channel, rejection);
      });
}

void DetectorNode::forget(const forget_t& message) {
  forgotten_.set(message.utime);
  if (const auto region = region_of(message, placement_ ? &*placement_ : nullptr, frame_)) {
    lasting_.forget(region->X_WR, region->box_R);
  } else {
    lasting_.forget();
  }
  const std::lock_guard lock(mutex_);
  counts_.remembered_views = static_cast<std::int64_t>(lasting_.size());
}

std::vector<Job> DetectorNode::find_due_jobs(Time now) {
  const std::lock_guard lock(mutex_);
  std::vector<Job> jobs = posed_clouds_.take_due(now);
  posed_views_.take_due(now, &jobs);
  return jobs;
}

std::optional<Job> DetectorNode::receive_cloud(const std::string& channel,
                                               std::span<const std::byte> bytes) {
  const TimePoint now = std::chrono::steady_clock::now();
  auto decoded = decode_cloud(bytes, settings_.frames);
  const std::lock_guard lock(mutex_);
  ++counts_.received;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  auto cloud = refusals_.accept(channel, std::move(decoded));
  if (!cloud) return std::nullopt;
  if (const auto rejection = cloud_channels_.refuse(channel, now)) {
    refusals_.add(channel, *rejection);
    return std::nullopt;
  }
  ++counts_.decoded;
  stages_.add("decode", bus::ms_since(now));
  gaps_.add(channel + '\n' + cloud->cloud.frame, cloud->seq);
  const auto shared = std::make_shared<const bus::CloudMessage>(*std::move(cloud));
  return posed_clouds_.add(shared->utime, memory_of(shared->cloud),
                           [this, channel, shared, now](const CameraPose& pose) {
                             return Job{shared->utime,
                                        [this, channel, shared, pose, now] {
                                          detect_and_publish(channel, *shared, pose, now);
                                        },
                                        {},
                                        channel};
                           });
}

std::optional<Job> DetectorNode::receive_view(int camera, std::span<const std::byte> bytes) {
  auto decoded = decode_cloud(bytes, settings_.frames);
  const std::lock_guard lock(mutex_);
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  return posed_views_.add(camera, std::move(decoded));
}

}  // namespace quadrille

// The planner's messages: each is decoded, counted, and becomes a job if it calls for work.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "process/planner/node.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/poses/placed_cloud.hpp"
#include "run/clock.hpp"

namespace quadrille {

std::optional<Job> PlannerNode::receive(const std::string& channel,
                                        std::span<const std::byte> bytes) {
  if (channel == settings_.cloud_channel) return receive_cloud(channel, bytes);
  if (channel == settings_.quadrics_channel) return receive_quadrics(channel, bytes);
  if (channel == settings_.boxes_channel) {
    receive_boxes(channel, bytes);
    return std::nullopt;
  }
  if (channel == settings_.bodies_channel) {
    receive_bodies(channel, bytes);
    return std::nullopt;
  }
  if (channel == settings_.body_tracks_channel) {
    receive_body_tracks(channel, bytes);
    return std::nullopt;
  }
  if (channel == settings_.request_channel) return receive_request(channel, bytes);
  if (channel == settings_.forget_channel) return receive_forget(channel, bytes);
  if (channel == settings_.pose_channel) {
    const std::lock_guard lock(mutex_);
    posed_clouds_.receive_pose(bytes, &refused_poses_);
    return std::nullopt;
  }
  if (const int camera = posed_views_.camera_of(channel)) return receive_view(camera, bytes);
  const std::lock_guard lock(mutex_);
  if (posed_views_.receive_pose(channel, bytes, &refused_poses_)) return std::nullopt;
  if (knowledge_.receive(channel, bytes, &refused_knowledge_)) {
    counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  }
  return std::nullopt;
}

std::optional<Job> PlannerNode::receive_cloud(const std::string& channel,
                                              std::span<const std::byte> bytes) {
  const auto start = std::chrono::steady_clock::now();
  auto decoded = decode_cloud(bytes, settings_.frames);
  const double decode_ms = bus::ms_since(start);
  const std::lock_guard lock(mutex_);
  ++counts_.received_clouds;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  auto cloud = refused_clouds_.accept(channel, std::move(decoded));
  if (!cloud) return std::nullopt;
  ++counts_.decoded_clouds;
  stages_.add("decode", decode_ms);
  gaps_.add(cloud->cloud.frame, cloud->seq);
  const std::int64_t utime = cloud->utime;
  const std::size_t memory = memory_of(cloud->cloud);
  return posed_clouds_.add(
      utime, memory, [this, cloud = *std::move(cloud)](const CameraPose& pose) mutable {
        return make_job(pairing_.add(std::move(cloud), place(settings_.frames, pose)));
      });
}

std::optional<Job> PlannerNode::receive_view(int camera, std::span<const std::byte> bytes) {
  auto decoded = decode_cloud(bytes, settings_.frames);
  const std::lock_guard lock(mutex_);
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  return posed_views_.add(camera, std::move(decoded));
}

std::optional<Job> PlannerNode::receive_quadrics(const std::string& channel,
                                                 std::span<const std::byte> bytes) {
  auto decoded = bus::decode_quadrics(bytes);
  const std::lock_guard lock(mutex_);
  ++counts_.received_quadrics;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  const auto quadrics = refused_quadrics_.accept(channel, std::move(decoded));
  if (!quadrics) return std::nullopt;
  ++counts_.decoded_quadrics;
  OtherThings others;
  if (auto boxes = boxes_.take(*quadrics)) others.boxes = std::move(boxes->boxes);
  if (auto bodies = bodies_.take(*quadrics)) others.bodies = std::move(bodies->bodies);
  if (const auto tracks = body_tracks_.take(*quadrics)) bus::set_tracks(*tracks, &others.bodies);
  const bool waits = posed_clouds_.follow(
      quadrics->utime,
      [this, quadrics, others](const CameraPose&) { return pair_quadrics(*quadrics, others); });
  return waits ? std::nullopt : pair_quadrics(*quadrics, others);
}

/// Pairs quadrics, and what came with them, with their cloud. The mutex must be held.
std::optional<Job> PlannerNode::pair_quadrics(const bus::QuadricsMessage& quadrics,
                                              const OtherThings& others) {
  auto job = make_job(pairing_.add(quadrics, others));
  if (const auto given_up = pairing_.take_given_up()) {
    unpaired_log_.warning(fmt::format("{}: the quadrics of cloud {} are not planned on: {}",
                                      settings_.quadrics_channel, given_up->utime,
                                      explain(given_up->why)));
  }
  return job;
}

void PlannerNode::receive_boxes(const std::string& channel, std::span<const std::byte> bytes) {
  auto decoded = bus::decode_boxes(bytes);
  const std::lock_guard lock(mutex_);
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  auto boxes = refused_boxes_.accept(channel, std::move(decoded));
  if (boxes) boxes_.add(*std::move(boxes));
}

void PlannerNode::receive_bodies(const std::string& channel, std::span<const std::byte> bytes) {
  auto decoded = bus::decode_bodies(bytes);
  const std::lock_guard lock(mutex_);
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  auto bodies = refused_bodies_.accept(channel, std::move(decoded));
  if (bodies) bodies_.add(*std::move(bodies));
}

void PlannerNode::receive_body_tracks(const std::string& channel,
                                      std::span<const std::byte> bytes) {
  auto decoded = bus::decode_body_tracks(bytes);
  const std::lock_guard lock(mutex_);
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  auto tracks = refused_bodies_.accept(channel, std::move(decoded));
  if (tracks) body_tracks_.add(*std::move(tracks));
}

std::optional<Job> PlannerNode::receive_request(const std::string& channel,
                                                std::span<const std::byte> bytes) {
  auto decoded = bus::decode_request(bytes);
  const std::lock_guard lock(mutex_);
  ++requests_;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  const auto request = refused_requests_.accept(channel, std::move(decoded));
  if (!request) return std::nullopt;
  const auto now = std::chrono::steady_clock::now();
  return Job{request->cloud_utime, [this, request, now] { answer(*request, now); },
             [this, request](const std::string& why) { refuse(*request, nullptr, why); }};
}

std::optional<Job> PlannerNode::receive_forget(const std::string& channel,
                                               std::span<const std::byte> bytes) {
  auto decoded = bus::decode_forget(bytes);
  const std::lock_guard lock(mutex_);
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  const auto message = refused_knowledge_.accept(channel, std::move(decoded));
  if (!message) return std::nullopt;
  return forgetting_job(
      channel, *message, [this](const forget_t& what) { forget(what); },
      [this, channel](const bus::Rejection& rejection) {
        const std::lock_guard lock(mutex_);
        refused_knowledge_.add(channel, rejection);
      });
}

}  // namespace quadrille

#include "node.hpp"

#include <spdlog/spdlog.h>

#include <utility>

#include "messages.hpp"
#include "quadrille/bus/clock.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/network.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille {

PlannerNode::PlannerNode(const PlannerSettings& settings, bus::Publish publish)
    : settings_(settings),
      publish_(std::move(publish)),
      dropped_before_(bus::count_dropped_datagrams()) {}

template <class Message>
std::optional<CloudAndQuadrics> PlannerNode::accept(bus::Decoded<Message> decoded,
                                                    const std::string& channel,
                                                    std::int64_t* accepted,
                                                    bus::RejectCounts* rejected) {
  if (const auto* rejection = std::get_if<bus::Rejection>(&decoded)) {
    rejected->add(rejection->reason);
    log_rejection(channel, *rejection);
    return std::nullopt;
  }
  ++*accepted;
  Message message = std::get<Message>(std::move(decoded));
  last_utime_ = message.utime;
  return pairing_.add(std::move(message));
}

std::optional<CloudAndQuadrics> PlannerNode::receive(const std::string& channel,
                                                     std::span<const std::byte> bytes) {
  const bool is_cloud = channel == settings_.cloud_channel;
  if (!is_cloud && channel != settings_.quadrics_channel) return std::nullopt;
  if (is_cloud) {
    auto decoded = bus::decode_cloud(bytes);
    const std::lock_guard lock(mutex_);
    ++counts_.received_clouds;
    counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
    return accept(std::move(decoded), channel, &counts_.decoded_clouds, &rejected_clouds_);
  }
  auto decoded = bus::decode_quadrics(bytes);
  const std::lock_guard lock(mutex_);
  ++counts_.received_quadrics;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  return accept(std::move(decoded), channel, &counts_.decoded_quadrics, &rejected_quadrics_);
}

void PlannerNode::log_rejection(const std::string& channel, const bus::Rejection& rejection) {
  const auto held_back = rejection_log_.admit();
  if (!held_back) return;
  spdlog::warn("{}: refused a message: {} ({}); {} more since the last record", channel,
               to_string(rejection.reason), rejection.detail, *held_back);
}

void PlannerNode::handle(const CloudAndQuadrics& pair) {
  try {
    plan_and_publish(pair);
  } catch (const std::exception& error) {
    spdlog::error("cloud {}: {}", pair.cloud->utime, error.what());
    const std::lock_guard lock(mutex_);
    ++counts_.failed;
  }
}

template <class Message>
std::int64_t PlannerNode::publish(const std::string& channel, const Message& message) {
  const auto bytes = bus::encode(message);
  publish_(channel, bytes);
  return static_cast<std::int64_t>(bytes.size());
}

void PlannerNode::plan_and_publish(const CloudAndQuadrics& pair) {
  const GraspPlan plan =
      plan_grasps(pair.cloud->cloud, pair.quadrics.detections, settings_.gripper, settings_.plan);
  std::int64_t bytes =
      publish(settings_.grasps_channel, make_grasps_message(*pair.cloud, plan, settings_));
  const double latency = bus::ms_since(pair.at);
  bytes += publish(settings_.shapes_channel, make_shapes_message(*pair.cloud, plan));
  bytes += publish(settings_.occupancy_channel, make_occupancy_message(*pair.cloud, plan));
  spdlog::debug("cloud {}: {} quadrics, {} grasps, {:.1f} ms", pair.cloud->utime,
                pair.quadrics.detections.size(), plan.grasps.size(), latency);
  for (const std::string& warning : plan.warnings) {
    spdlog::debug("cloud {}: {}", pair.cloud->utime, warning);
  }
  const std::lock_guard lock(mutex_);
  ++counts_.published;
  counts_.published_bytes += bytes;
  counts_.cloud_utime = pair.cloud->utime;
  latencies_.add(latency);
  plans_.add(plan.total_ms);
}

void PlannerNode::publish_status(std::int64_t superseded,
                                 const std::vector<std::string>& warnings) {
  planner_status_t status = make_status();
  status.superseded = superseded;
  status.warnings = warnings;
  status.num_warnings = static_cast<std::int32_t>(warnings.size());
  publish(settings_.status_channel, status);
}

planner_status_t PlannerNode::make_status() const {
  const std::lock_guard lock(mutex_);
  planner_status_t status = counts_;
  status.utime = bus::wall_clock_utime();
  status.paired = pairing_.paired();
  status.unpaired_quadrics = pairing_.unpaired();
  status.dropped_datagrams =
      dropped_before_ < 0 ? -1 : bus::count_dropped_datagrams() - dropped_before_;
  status.rejected_clouds = bus::to_message(rejected_clouds_);
  status.num_rejected_clouds = static_cast<std::int32_t>(status.rejected_clouds.size());
  status.rejected_quadrics = bus::to_message(rejected_quadrics_);
  status.num_rejected_quadrics = static_cast<std::int32_t>(status.rejected_quadrics.size());
  const bus::DurationSummary latency = latencies_.summary(), plan = plans_.summary();
  status.latency_p50 = latency.p50;
  status.latency_p95 = latency.p95;
  status.latency_max = latency.max;
  status.plan_p50 = plan.p50;
  status.plan_p95 = plan.p95;
  status.plan_max = plan.max;
  return status;
}

std::int64_t PlannerNode::failed() const {
  const std::lock_guard lock(mutex_);
  return counts_.failed;
}

std::int64_t PlannerNode::paired() const {
  const std::lock_guard lock(mutex_);
  return pairing_.paired();
}

std::int64_t PlannerNode::last_utime() const {
  const std::lock_guard lock(mutex_);
  return last_utime_;
}

}  // namespace quadrille

#include "process/planner/node.hpp"

#include <fmt/format.h>

#include <utility>

#include "process/planner/messages.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/status.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille {

PlannerNode::PlannerNode(const PlannerSettings& settings, bus::Publish publish)
    : settings_(settings),
      publish_(std::move(publish)),
      dropped_before_(bus::count_dropped_datagrams()) {}

std::vector<InChannel> PlannerNode::in_channels() const {
  return {{"--cloud-channel", settings_.cloud_channel},
          {"--quadrics-channel", settings_.quadrics_channel}};
}

template <class Message>
std::optional<Job> PlannerNode::accept(bus::Decoded<Message> decoded, const std::string& channel,
                                       std::int64_t* accepted, Refusals* refusals) {
  if (const auto* rejection = std::get_if<bus::Rejection>(&decoded)) {
    refusals->add(channel, *rejection);
    return std::nullopt;
  }
  ++*accepted;
  auto pair = pairing_.add(std::get<Message>(std::move(decoded)));
  if (!pair) return std::nullopt;
  const std::int64_t utime = pair->cloud->utime;
  return Job{utime, [this, pair = std::move(*pair)] { plan_and_publish(pair); }};
}

std::optional<Job> PlannerNode::receive(const std::string& channel,
                                        std::span<const std::byte> bytes) {
  const bool is_cloud = channel == settings_.cloud_channel;
  if (!is_cloud && channel != settings_.quadrics_channel) return std::nullopt;
  if (is_cloud) {
    auto decoded = bus::decode_cloud(bytes);
    const std::lock_guard lock(mutex_);
    ++counts_.received_clouds;
    counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
    return accept(std::move(decoded), channel, &counts_.decoded_clouds, &refused_clouds_);
  }
  auto decoded = bus::decode_quadrics(bytes);
  const std::lock_guard lock(mutex_);
  ++counts_.received_quadrics;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  return accept(std::move(decoded), channel, &counts_.decoded_quadrics, &refused_quadrics_);
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
  bytes +=
      publish(settings_.occupancy_channel, make_occupancy_message(*pair.cloud, plan.space.get()));
  log_debug(fmt::format("cloud {}: {} quadrics, {} grasps, {:.1f} ms", pair.cloud->utime,
                        pair.quadrics.detections.size(), plan.grasps.size(), latency));
  for (const std::string& warning : plan.warnings) {
    log_debug(fmt::format("cloud {}: {}", pair.cloud->utime, warning));
  }
  const std::lock_guard lock(mutex_);
  ++counts_.published;
  counts_.published_bytes += bytes;
  counts_.cloud_utime = pair.cloud->utime;
  grasps_ += static_cast<std::int64_t>(plan.grasps.size());
  latencies_.add(latency);
  plan_times_.add(plan.total_ms);
}

void PlannerNode::publish_status(std::int64_t superseded,
                                 const std::vector<std::string>& warnings) {
  planner_status_t status = make_status();
  set_transport(superseded, warnings, dropped_before_, &status);
  publish(settings_.status_channel, status);
}

planner_status_t PlannerNode::make_status() const {
  const std::lock_guard lock(mutex_);
  planner_status_t status = counts_;
  status.paired = pairing_.paired();
  status.unpaired_quadrics = pairing_.unpaired();
  status.failed = failed();
  status.rejected_clouds = bus::to_message(refused_clouds_.counts());
  status.num_rejected_clouds = static_cast<std::int32_t>(status.rejected_clouds.size());
  status.rejected_quadrics = bus::to_message(refused_quadrics_.counts());
  status.num_rejected_quadrics = static_cast<std::int32_t>(status.rejected_quadrics.size());
  set_latency(latencies_.summary(), &status);
  const bus::DurationSummary plan = plan_times_.summary();
  status.plan_p50 = plan.p50;
  status.plan_p95 = plan.p95;
  status.plan_max = plan.max;
  return status;
}

std::string PlannerNode::summary() const {
  const std::lock_guard lock(mutex_);
  return fmt::format(
      "clouds in: {}, {}; messages of quadrics in: {}, {}; pairs: {}; grasps out: {}",
      counts_.received_clouds, describe(refused_clouds_.counts()), counts_.received_quadrics,
      describe(refused_quadrics_.counts()), pairing_.paired(), grasps_);
}

std::vector<std::string> PlannerNode::find_oddities() const {
  const std::lock_guard lock(mutex_);
  if (pairing_.paired() > 0) return {};
  return {"no quadrics with their cloud; make it with quadrille-detector --copy-input"};
}

}  // namespace quadrille

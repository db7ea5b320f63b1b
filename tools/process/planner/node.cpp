#include "process/planner/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "process/planner/messages.hpp"
#include "process/planner/request.hpp"
#include "process/planner/status_text.hpp"
#include "process/planner/viewer_hands.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/poses/forgetting.hpp"
#include "process/runtime/poses/placed_cloud.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/rigid_motion.hpp"
#include "run/clock.hpp"

namespace quadrille {
PlannerNode::PlannerNode(const PlannerSettings& settings, bus::Publish publish)
    : settings_(settings),
      publish_(std::move(publish)),
      settings_hash_(hash_of(settings)),
      posed_clouds_({settings.pose_channel, settings.X_WK, settings.pose_age, settings.pose_wait},
                    settings.frames.need_pose() ? "planned on" : "placed in the fixed frame"),
      posed_views_(settings.view_cameras, settings.pose_age, settings.pose_wait,
                   [this](int camera, const bus::CloudMessage& cloud, const CameraPose& pose) {
                     remember_view(camera, cloud, pose);
                   }),
      knowledge_(settings_),
      planner_(settings_),
      occupancies_(settings, publish_) {
  if (settings.viz) viewer_.emplace(settings.viewer, publish_);
  log_info(fmt::format("plans for the hand {}", settings.gripper.name));
}

std::vector<InChannel> PlannerNode::in_channels() const {
  std::vector<InChannel> channels;
  PlannerSettings::visit_channels(
      settings_, [&](Way way, const char* option, const std::string& name, const char*) {
        if (way != Way::kIn || name.empty()) return;
        // All others add to what these say, or stand in for what the planner finds itself.
        const bool expected =
            &name == &settings_.cloud_channel || &name == &settings_.quadrics_channel ||
            &name == &settings_.pose_channel || std::string_view(option) == kViewCameraOption ||
            (&name == &settings_.request_channel && settings_.on_request);
        channels.push_back({option, name, expected});
      });
  return channels;
}

std::vector<OutChannel> PlannerNode::out_channels() const {
  std::vector<OutChannel> channels;
  PlannerSettings::visit_channels(
      settings_, [&](Way way, const char* option, const std::string& name, const char*) {
        if (way == Way::kOut) channels.push_back({option, name});
      });
  PlannerSettings::visit_viewer(settings_, [&](const std::string& name) {
    channels.push_back({"--viz", name});
  });
  return channels;
}

std::vector<Job> PlannerNode::find_due_jobs(Time now) {
  const std::lock_guard lock(mutex_);
  std::vector<Job> jobs = posed_clouds_.take_due(now);
  posed_views_.take_due(now, &jobs);
  return jobs;
}

std::optional<Job> PlannerNode::make_job(std::optional<CloudAndQuadrics> found) {
  if (!found) return std::nullopt;
  auto pair = std::make_shared<const CloudAndQuadrics>(std::move(*found));
  recent_.add(pair);
  if (!settings_.on_request) {
    return Job{pair->cloud->utime, [this, pair] { plan_and_publish(pair); }};
  }
  if (!settings_.remembers()) return std::nullopt;
  return Job{pair->cloud->utime, [this, pair] { remember(pair); }};
}

template <class Message>
std::int64_t PlannerNode::publish(const std::string& channel, const Message& message) {
  const auto bytes = bus::encode(message);
  publish_(channel, bytes);
  return static_cast<std::int64_t>(bytes.size());
}

/// Returns what is known about a cloud. If that is in a frame which is not known, no grasp could
/// keep clear of it: then nullopt, and the plan says so.
std::optional<Known> PlannerNode::known_about(const CloudAndQuadrics& pair, GraspPlan* without) {
  const std::lock_guard lock(mutex_);
  try {
    return knowledge_.about(pair);
  } catch (const std::invalid_argument& error) {
    without->warnings = {std::string("what is known of the scene cannot be placed: ") +
                         error.what()};
    return std::nullopt;
  }
}

void PlannerNode::remember(const SharedPair& pair) {
  GraspPlan nothing;
  if (const std::optional<Known> known = known_about(*pair, &nothing)) {
    planner_.remember(*pair, *known);
  }
}

/// Remembers what a further camera saw.
void PlannerNode::remember_view(int camera, const bus::CloudMessage& cloud,
                                const CameraPose& pose) {
  if (!pose.X_WK) return;
  std::optional<RobotShapes> robot_K;
  {
    const std::lock_guard lock(mutex_);
    robot_K = knowledge_.robot_at_view(cloud.utime, *pose.X_WK, &refused_knowledge_);
  }
  if (robot_K) planner_.remember(cloud, place(settings_.frames, pose), *robot_K, camera);
}

void PlannerNode::forget(const forget_t& message) {
  SharedPair pair;
  {
    const std::lock_guard lock(mutex_);
    pair = recent_.newest();
  }
  planner_.forget(message.utime, region_of(message, pair ? &pair->placement : nullptr,
                                           pair ? pair->cloud->cloud.frame : ""));
}

void PlannerNode::plan_and_publish(const SharedPair& shared) {
  const CloudAndQuadrics& pair = *shared;
  const auto start = std::chrono::steady_clock::now();
  GraspPlan plan;
  if (const std::optional<Known> known = known_about(pair, &plan)) {
    planner_.remember(pair, *known);
    plan = planner_.plan(shared, *known, {});
  }
  const double plan_ms = bus::ms_since(start);
  const Stamp stamp{pair.cloud->utime, pair.cloud->seq,
                    pair.placement.frame_of_results(pair.cloud->cloud.frame)};
  const std::int64_t grasp_bytes =
      publish(settings_.grasps_channel, make_grasps_message(stamp, plan, settings_));
  const double latency = bus::ms_since(pair.at);
  std::int64_t bytes = grasp_bytes + publish_maps(stamp, plan, pair.placement.X_RK);
  const double maps_ms = bus::ms_since(pair.at) - latency;
  if (viewer_) bytes += viewer_->show(stamp.utime, hand_links(plan, settings_.gripper));
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
  stages_.add("wait", std::chrono::duration<double, std::milli>(start - pair.at).count());
  stages_.add("plan", plan_ms);
  stages_.add("grasps", latency);
  stages_.add("maps", maps_ms);
}

/// Publishes the shapes and the map, as far as they are wanted.
/// @return number of bytes published
std::int64_t PlannerNode::publish_maps(const Stamp& stamp, const GraspPlan& plan,
                                       const Eigen::Isometry3d& X_RK) {
  std::int64_t bytes = 0;
  if (settings_.shapes) {
    bytes += publish(settings_.shapes_channel, make_shapes_message(stamp, plan));
  }
  if (!settings_.occupancy) return bytes;
  return plan.space ? bytes + occupancies_.add({stamp, plan.space, X_RK}) : bytes;
}

/// Returns the job of publishing the last cloud's map, once it is due.
std::optional<Job> PlannerNode::find_spare_job() {
  std::optional<MapPublisher::Map> due = occupancies_.take_due();
  if (!due) return std::nullopt;
  return Job{due->stamp.utime, [this, map = *std::move(due)] {
               const std::int64_t bytes = occupancies_.publish(map);
               const std::lock_guard lock(mutex_);
               counts_.published_bytes += bytes;
             }};
}

void PlannerNode::answer(const grasp_request_t& request, std::chrono::steady_clock::time_point at) {
  SharedPair pair;
  {
    const std::lock_guard lock(mutex_);
    pair = request.cloud_utime == 0 ? recent_.newest() : recent_.find(request.cloud_utime);
  }
  if (!pair && request.cloud_utime == 0) {
    return refuse(request, pair, "no cloud has come with its quadrics yet");
  }
  if (!pair) {
    return refuse(request, pair,
                  fmt::format("cloud {} is not kept, or its quadrics have not come; ask for 0, the "
                              "newest",
                              request.cloud_utime));
  }
  GraspQuery query;
  try {
    query = query_of(request, pair->placement, pair->cloud->cloud.frame);
  } catch (const std::invalid_argument& error) {
    return refuse(request, pair, error.what());
  }
  GraspPlan plan;
  if (const std::optional<Known> known = known_about(*pair, &plan)) {
    plan = planner_.plan(pair, *known, query, request.advise);
  }
  publish_answer(request, pair, plan);
  log_debug(fmt::format("request {}: cloud {}, {:.1f} ms", request.request_id, pair->cloud->utime,
                        bus::ms_since(at)));
}

/// Answers a request with an empty plan and the reason.
void PlannerNode::refuse(const grasp_request_t& request, const SharedPair& pair,
                         const std::string& why) {
  GraspPlan nothing;
  nothing.warnings = {why};
  publish_answer(request, pair, nothing);
  const std::lock_guard lock(mutex_);
  ++unmet_;
}

void PlannerNode::publish_answer(const grasp_request_t& request, const SharedPair& pair,
                                 const GraspPlan& plan) {
  Stamp stamp{request.cloud_utime, 0, request.frame, request.request_id};
  if (pair) {
    stamp.utime = pair->cloud->utime;
    stamp.seq = pair->cloud->seq;
    stamp.frame = pair->placement.frame_of_results(pair->cloud->cloud.frame);
  }
  const std::int64_t bytes =
      publish(settings_.grasps_channel, make_grasps_message(stamp, plan, settings_)) +
      (viewer_ && pair ? viewer_->show(stamp.utime, hand_links(plan, settings_.gripper)) : 0);
  const std::lock_guard lock(mutex_);
  counts_.published_bytes += bytes;
  if (pair) counts_.cloud_utime = pair->cloud->utime;
  ++counts_.answered;
}

}  // namespace quadrille

#include "process/detector/node.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "io/json/shapes_file.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/poses/placed_cloud.hpp"
#include "process/runtime/status/process_info.hpp"
#include "process/runtime/watch/other_senders.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "run/clock.hpp"

namespace quadrille {
namespace {

std::string hash_of(const DetectorSettings& settings) {
  SettingsText text;
  text.add_all(settings.detector);
  text.add_all(settings.track);
  text.add_channels(channels_of(settings));
  text.add_frames(settings.frames, settings.X_WK);
  for (const ViewCamera& camera : settings.view_cameras) {
    text.add_frames(settings.frames, camera.X_WK);
  }
  text.add("padding", fmt::format("{}", settings.robot.padding));
  for (const SolidShape& shape : settings.robot.shapes) {
    text.add("robot", io::to_json(shape).dump());
  }
  return text.hash();
}

/// Returns true if the camera's pose is given or comes, and something depends on it.
bool uses_poses(const DetectorSettings& settings) {
  const bool wanted = settings.track.enabled || settings.remembers() || settings.frames.need_pose();
  return settings.X_WK || (!settings.pose_channel.empty() && wanted);
}

/// Returns the source of the camera's poses. If none are used, the fixed frame is the camera's.
PoseSource pose_source(const DetectorSettings& settings) {
  PoseSource source{settings.pose_channel, settings.X_WK, settings.track.pose_age,
                    settings.track.pose_wait};
  if (!uses_poses(settings)) source.fixed.emplace().setIdentity();
  return source;
}

}  // namespace

DetectorNode::DetectorNode(const DetectorSettings& settings, bus::Publish publish)
    : settings_(settings),
      publish_(std::move(publish)),
      settings_hash_(hash_of(settings)),
      trackers_(settings.track),
      lasting_(settings.detector),
      posed_clouds_(pose_source(settings), settings.frames.need_pose() ? "searched" : "tracked"),
      posed_views_(settings.view_cameras, settings.track.pose_age, settings.track.pose_wait,
                   [this](int camera, const bus::CloudMessage& cloud, const CameraPose& pose) {
                     remember_view(camera, cloud, pose);
                   }),
      cloud_channels_(settings_),
      robot_({0,
              std::string(
                  to_string(settings.has_fixed_frame() ? CloudFrame::kWorld : CloudFrame::kCamera)),
              settings.robot,
              {}}) {
  if (settings.viz) viewer_.emplace(settings.viewer, publish_);
}

std::vector<InChannel> DetectorNode::in_channels() const {
  std::vector<InChannel> channels;
  DetectorSettings::visit_channels(
      settings_, [&](Way way, const char* option, const std::string& name, const char*) {
        if (way != Way::kIn || name.empty()) return;
        const bool seldom = &name == &settings_.robot_channel || &name == &settings_.forget_channel;
        channels.push_back({option, name, !seldom});
      });
  return channels;
}

std::vector<OutChannel> DetectorNode::out_channels() const {
  return cloud_channels_.out_channels();
}

/// Detects in a cloud and in what others showed before it, and remembers it.
/// @param cloud_K  the cloud in the camera's frame, without points on the robot
DetectionResult DetectorNode::detect_lasting(const bus::CloudMessage& cloud,
                                             const PointCloud& cloud_K,
                                             const Eigen::Isometry3d& X_WK, int camera) {
  DetectionResult result = lasting_.detect(cloud.utime, cloud_K, X_WK, camera);
  const Eigen::Vector3d p_W = X_WK.translation();
  const std::lock_guard lock(mutex_);
  counts_.remembered_views = static_cast<std::int64_t>(lasting_.size());
  counts_.pose_correction = (lasting_.correction(camera) * p_W - p_W).norm();
  return result;
}

/// Remembers what a further camera saw. What is found there serves later clouds alone.
void DetectorNode::remember_view(int camera, const bus::CloudMessage& cloud,
                                 const CameraPose& pose) {
  if (!pose.X_WK || forgotten_.is_after(cloud.utime)) return;
  std::optional<RobotShapes> robot_K;
  {
    const std::lock_guard lock(mutex_);
    robot_K = robot_.at_view(cloud.utime, *pose.X_WK, settings_.robot_channel, &refused_knowledge_);
  }
  if (!robot_K) return;
  const Placement placement = place(settings_.frames, pose);
  const DetectionResult result = detect_lasting(
      cloud, robot_K->taken_from(in_camera_frame(cloud.cloud, placement, settings_.frames)),
      *pose.X_WK, camera);
  for (const std::string& warning : result.warnings) {
    warnings_log_.warning(
        fmt::format("{}: cloud {}: {}", posed_views_.channel(camera), cloud.utime, warning));
  }
}

/// Detects and tracks in a cloud and returns the result in the frame of the results. The result is
/// empty if that needs a pose which is not known.
DetectionResult DetectorNode::detect_placed(const std::string& channel,
                                            const bus::CloudMessage& cloud, const CameraPose& pose,
                                            const Placement& placement) {
  if (!placement.lack.empty()) {
    DetectionResult nothing;
    nothing.warnings = {"the camera's pose is not known: " + placement.lack};
    return nothing;
  }
  RobotShapes robot;
  try {
    robot = robot_at(cloud, placement);
  } catch (const std::invalid_argument& error) {
    DetectionResult nothing;
    nothing.warnings = {std::string("the robot's shapes cannot be placed: ") + error.what()};
    return nothing;
  }
  const PointCloud cloud_K =
      robot.taken_from(in_camera_frame(cloud.cloud, placement, settings_.frames));
  const bool lasts = settings_.remembers() && pose.X_WK && !forgotten_.is_after(cloud.utime);
  DetectionResult result =
      lasts ? detect_lasting(cloud, cloud_K, *pose.X_WK) : detect(cloud_K, settings_.detector);
  if (pose.X_WK) track(channel, cloud, *pose.X_WK, &result);
  result.detections = moved(std::move(result.detections), placement.X_RK);
  result.boxes = moved(std::move(result.boxes), placement.X_RK);
  result.bodies = moved(std::move(result.bodies), placement.X_RK);
  return result;
}

/// Returns the robot's shapes in the camera's frame.
/// @throws std::invalid_argument if their frame is not known
RobotShapes DetectorNode::robot_at(const bus::CloudMessage& cloud, const Placement& placement) {
  Placement known = placement;
  // Without poses, the fixed frame of the tracks is none that others know.
  if (!uses_poses(settings_)) known.X_WK.reset();
  const std::lock_guard lock(mutex_);
  return robot_.at(cloud.utime, known, cloud.cloud.frame);
}

/// Assigns tracks to the surfaces and bodies of a cloud.
void DetectorNode::track(const std::string& channel, const bus::CloudMessage& cloud,
                         const Eigen::Isometry3d& X_WK, DetectionResult* result) {
  const std::int64_t before = trackers_.given_up();
  trackers_.of(channel, cloud.cloud.frame).update(cloud.utime, X_WK, result);
  if (trackers_.given_up() == before) return;
  trackers_log_.warning(
      fmt::format("{}: the clouds have more than {} frames, and tracks of the oldest begin anew; "
                  "give each camera one name for its frame",
                  channel, Trackers::kMaxTrackers));
}

void DetectorNode::detect_and_publish(const std::string& channel, const bus::CloudMessage& cloud,
                                      const CameraPose& pose, TimePoint received) {
  const TimePoint start = std::chrono::steady_clock::now();
  const Placement placement = place(settings_.frames, pose);
  placement_ = placement;
  frame_ = cloud.cloud.frame;
  const std::string& frame = placement.frame_of_results(cloud.cloud.frame);
  const DetectionResult result = detect_placed(channel, cloud, pose, placement);
  const double detect_ms = bus::ms_since(start);
  // The planner plans as soon as it has the quadrics, so what else it needs comes first.
  publish_bodies(channel, cloud, frame, result);
  publish_quadrics(channel, cloud, frame, result);
  const double latency = bus::ms_since(received);
  if (viewer_ && placement.lack.empty()) show(cloud, placement, result);
  log_debug(fmt::format("cloud {}: {} of {} points, {} quadrics, {} boxes, {:.1f} ms", cloud.utime,
                        result.points_used, cloud.cloud.read, result.detections.size(),
                        result.boxes.size(), latency));
  for (const std::string& warning : result.warnings) {
    warnings_log_.warning(fmt::format("{}: cloud {}: {}", channel, cloud.utime, warning));
  }
  const std::lock_guard lock(mutex_);
  stages_.add("wait", std::chrono::duration<double, std::milli>(start - received).count());
  stages_.add("detect", detect_ms);
  stages_.add("quadrics", latency);
}

void DetectorNode::publish_quadrics(const std::string& channel, const bus::CloudMessage& cloud,
                                    const std::string& frame, const DetectionResult& result) {
  quadrics_t message = bus::to_message(cloud, result);
  message.frame = frame;
  const auto bytes = bus::encode(message);
  publish_(cloud_channels_.results_channel(settings_.out_channel, channel), bytes);
  const std::lock_guard lock(mutex_);
  ++counts_.published;
  counts_.published_bytes += static_cast<std::int64_t>(bytes.size());
  counts_.cloud_utime = cloud.utime;
  detections_ += static_cast<std::int64_t>(result.detections.size());
}

/// Publishes the boxes, the bodies, of which boxes are a part, and their tracks.
void DetectorNode::publish_bodies(const std::string& channel, const bus::CloudMessage& cloud,
                                  const std::string& frame, const DetectionResult& result) {
  boxes_t boxes = bus::to_message(cloud, result.boxes);
  bodies_t bodies = bus::to_message(cloud, result.bodies);
  body_tracks_t tracks = bus::tracks_message(cloud, result.bodies);
  boxes.frame = bodies.frame = tracks.frame = frame;
  const std::pair<const std::string&, std::vector<std::byte>> messages[] = {
      {settings_.boxes_channel, bus::encode(boxes)},
      {settings_.bodies_channel, bus::encode(bodies)},
      {settings_.body_tracks_channel, bus::encode(tracks)}};
  for (const auto& [results, bytes] : messages) {
    publish_(cloud_channels_.results_channel(results, channel), bytes);
    const std::lock_guard lock(mutex_);
    counts_.published_bytes += static_cast<std::int64_t>(bytes.size());
  }
}

}  // namespace quadrille

#include "view/live/live_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

#include "poses/pose_history.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/occupancy_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/detector/setting.hpp"
#include "view/live/live_surroundings.hpp"
#include "view/scene/octree_leaves.hpp"

namespace quadrille::view {
namespace {

/// Decodes a message; nullopt if there are no bytes, or they are damaged.
template <class Message, class Decode>
std::optional<Message> read(const Bytes& bytes, const Decode& decode) {
  if (!bytes) return std::nullopt;
  auto decoded = decode(*bytes);
  if (auto* const message = std::get_if<Message>(&decoded)) return std::move(*message);
  return std::nullopt;
}

/// Returns the cloud with the time and number of the quadrics; the newest if there are no quadrics.
/// @param unit  length of the unit of its coordinates [m]
std::optional<bus::CloudMessage> find_cloud(const std::deque<Bytes>& clouds,
                                            const std::optional<bus::QuadricsMessage>& quadrics,
                                            double unit) {
  for (auto bytes = clouds.rbegin(); bytes != clouds.rend(); ++bytes) {
    const auto stamp = bus::read_stamp(**bytes);
    if (!stamp) continue;
    if (quadrics && (stamp->utime != quadrics->utime || stamp->seq != quadrics->seq)) continue;
    const auto decode = [unit](const auto& b) {
      return bus::decode_cloud(b, bus::kMaxMessageBytes, bus::CloudColours::kKeep, unit);
    };
    if (auto cloud = read<bus::CloudMessage>(*bytes, decode)) return cloud;
  }
  return std::nullopt;
}

std::optional<grasps_t> read_grasps(const Bytes& bytes) {
  return read<grasps_t>(bytes, [](const auto& b) { return bus::decode_grasps(b); });
}

Grasp from_message(const grasp_t& m) {
  Grasp grasp;
  grasp.target = m.target;
  grasp.track = m.track;
  grasp.kind = static_cast<GraspKind>(std::clamp<int>(m.kind, 0, 3));
  grasp.score = m.score;
  grasp.X_CG = bus::from_message(m.pose);
  grasp.width = m.width;
  grasp.preshape = m.preshape;
  for (std::size_t i = 0; i < 2; ++i) {
    grasp.contacts_C[i] = Eigen::Vector3d(m.contacts[i][0], m.contacts[i][1], m.contacts[i][2]);
  }
  grasp.approach = m.approach;
  grasp.friction_needed = m.friction_needed;
  grasp.epsilon = m.epsilon;
  grasp.clearance = m.clearance;
  grasp.unknown_contact = m.unknown_contact != 0;
  return grasp;
}

bool is_finite(const Grasp& g) {
  return g.X_CG.matrix().allFinite() && g.contacts_C[0].allFinite() &&
         g.contacts_C[1].allFinite() &&
         std::isfinite(g.width + g.preshape + g.approach + g.score + g.clearance);
}

/// Adds the proposed views. Those of an earlier cloud stay, since their places remain good; the
/// page needs only the number of their bodies.
void add_looks(const grasps_t& message, Scene* scene) {
  constexpr std::size_t kMaxLooks = 100;
  for (const look_t& m : message.looks) {
    if (scene->looks.size() == kMaxLooks) return;
    scene->looks.push_back({bus::from_message(m.pose), {m.bodies.begin(), m.bodies.end()}, m.gain});
  }
}

/// Returns which of the shown things a grasp belongs to; 0 if that is unknown.
int target_of(const Grasp& grasp, bool same_cloud, const Scene& scene) {
  if (same_cloud) return grasp.target;
  if (grasp.track == 0) return 0;
  for (const Detection& d : scene.detections) {
    if (d.track == grasp.track) return d.id;
  }
  const auto has_track = [&](int id) {
    const auto found = scene.sightings.find(id);
    return found != scene.sightings.end() && found->second.track == grasp.track;
  };
  for (const Box& box : scene.boxes) {
    if (has_track(box.id)) return box.id;
  }
  for (const SceneBody& lump : scene.lumps) {
    if (has_track(lump.id)) return lump.id;
  }
  return 0;
}

void add_grasps(const grasps_t& message, const FindGripper& find_gripper, std::size_t max_grasps,
                Scene* scene) {
  const bool same_cloud = message.utime == scene->utime && message.seq == scene->seq;
  for (const grasp_t& m : message.grasps) {
    Grasp grasp = from_message(m);
    if (scene->grasps.size() == max_grasps || !is_finite(grasp)) continue;
    grasp.target = target_of(grasp, same_cloud, *scene);
    scene->grasps.push_back(grasp);
  }
  scene->gripper_name = message.gripper;
  scene->gripper = find_gripper(message.gripper);
  for (const auto& [word, policy] : words_of(UnknownPolicy{})) {
    if (message.unknown == word) scene->unknown = policy;
  }
  for (const count_t& refused : message.rejected) scene->rejected[refused.name] = refused.count;
  if (same_cloud) {
    for (const target_outcome_t& target : message.targets) {
      Rejected& rejected = scene->rejected_of[target.target];
      for (const count_t& refused : target.rejected) rejected[refused.name] = refused.count;
    }
    for (const remedy_t& m : message.remedies) {
      scene->remedies.push_back({m.target, m.change, m.num_grasps, m.score});
    }
  }
  add_looks(message, scene);
  scene->warnings.insert(scene->warnings.end(), message.warnings.begin(), message.warnings.end());
}

/// Returns the boxes, bodies or tracks of the quadrics: the newest, or the ones before them if the
/// quadrics of the newest have not come yet.
template <class Message, class Decode>
std::optional<Message> find_of(const bus::QuadricsMessage& quadrics, const Bytes& newest,
                               const Bytes& before, Decode&& decode) {
  for (const Bytes& bytes : {newest, before}) {
    auto found = read<Message>(bytes, decode);
    if (found && found->utime == quadrics.utime && found->seq == quadrics.seq) return found;
  }
  return std::nullopt;
}

void add_quadrics(bus::QuadricsMessage message, const LatestMessages& messages, Scene* scene) {
  const auto boxes = find_of<bus::BoxesMessage>(message, messages.boxes, messages.boxes_before,
                                                [](const auto& b) { return bus::decode_boxes(b); });
  if (boxes) {
    std::copy_if(boxes->boxes.begin(), boxes->boxes.end(), std::back_inserter(scene->boxes),
                 [](const Box& box) { return is_reported(box); });
  }
  auto bodies = find_of<bus::BodiesMessage>(message, messages.bodies, messages.bodies_before,
                                            [](const auto& b) { return bus::decode_bodies(b); });
  const auto tracks =
      find_of<bus::BodyTracksMessage>(message, messages.body_tracks, messages.body_tracks_before,
                                      [](const auto& b) { return bus::decode_body_tracks(b); });
  if (bodies) {
    if (tracks) bus::set_tracks(*tracks, &bodies->bodies);
    scene->lumps = lumps_of(bodies->bodies);
    scene->sightings = sightings_of(bodies->bodies);
  }
  scene->utime = message.utime;
  scene->seq = message.seq;
  scene->detections = std::move(message.detections);
  std::erase_if(scene->detections, [](const Detection& d) { return !is_reported(d); });
}

/// Returns the frames at the time of the cloud. A scene of quadrics alone is in the frame of their
/// cloud, if that of the results is not another one.
SceneFrames frames_of(const LatestMessages& messages, const std::optional<bus::CloudMessage>& cloud,
                      const std::optional<bus::QuadricsMessage>& quadrics, bool cloud_in_world) {
  SceneFrames frames;
  if (cloud) frames.scene = cloud->cloud.frame;
  if (quadrics) frames.scene = quadrics->frame;
  frames.cloud = cloud ? cloud->cloud.frame : frames.scene;
  frames.cloud_in_world = cloud_in_world;
  const std::int64_t utime = quadrics ? quadrics->utime : cloud ? cloud->utime : 0;
  if (messages.camera) frames.X_WK = messages.camera->at(utime);
  return frames;
}

/// Says why a cloud in another frame than the results is not shown, and what helps.
std::string explain_missing_cloud(const LatestMessages& messages, const SceneFrames& frames,
                                  std::int64_t utime) {
  const std::string fact = "the cloud is not shown: it is in frame '" + frames.cloud +
                           "', the quadrics in '" + frames.scene + "'";
  if (!messages.camera) return fact + "; " + kPoseRemedy;
  return frames.X_WK ? fact : fact + ", and " + messages.camera->explain(utime);
}

/// Says why the cloud of the quadrics is not there.
std::string explain_absent_cloud(const LatestMessages& messages) {
  return messages.clouds.empty()
             ? "no cloud has come yet; is this the detector's: view --cloud-channel?"
             : "the cloud of these quadrics is not among the last that came; the detector lags "
               "behind, or reads another channel than view --cloud-channel";
}

/// Adds the cloud, moved into the frame of the quadrics; if that is not possible, only the quadrics
/// are shown.
void add_cloud(std::optional<bus::CloudMessage> cloud, const LatestMessages& messages,
               const SceneFrames& frames, Scene* scene) {
  scene->cloud.frame = frames.scene;
  if (!cloud) return;
  const auto X_SC = frames.X_SF(frames.cloud);
  if (!X_SC) {
    scene->warnings.push_back(explain_missing_cloud(messages, frames, cloud->utime));
    return;
  }
  scene->utime = cloud->utime;
  scene->seq = cloud->seq;
  scene->cloud = moved(std::move(cloud->cloud), *X_SC);
  scene->cloud.frame = frames.scene;
  // Only the pose tells where the sensor of a cloud in the fixed frame was.
  const auto X_SK = frames.X_SK();
  if (frames.cloud_in_world && X_SK) scene->cloud.viewpoint = X_SK->translation();
}

/// Names the cloud of a plan, such as "a cloud 0.40 s older"; "" if it is the one that is shown.
std::string describe_cloud(std::int64_t utime, std::int32_t seq, const Scene& scene) {
  if (utime == scene.utime && seq == scene.seq) return "";
  const double age = seconds_between(utime, scene.utime);
  // Clouds without times, or a clock that was set back, tell no age.
  return age > 0.0 ? fmt::format("a cloud {:.2f} s older", age) : "another cloud";
}

/// Adds the grasps. Those of an earlier cloud stay until the plan on this one comes, and the scene
/// says so.
void add_plan(const grasps_t& message, const FindGripper& find_gripper, std::size_t max_grasps,
              Scene* scene) {
  if (message.frame != scene->cloud.frame) {
    if (scene->cloud.frame.empty()) return;
    scene->warnings.push_back("the grasps are not shown: they are in frame '" +
                              printable(message.frame) + "', the rest in '" +
                              printable(scene->cloud.frame) +
                              "'; give detector and planner the same --result-frame");
    return;
  }
  add_grasps(message, find_gripper, max_grasps, scene);
  const std::string cloud = describe_cloud(message.utime, message.seq, *scene);
  if (!cloud.empty()) scene->notes.push_back("the grasps were planned on " + cloud);
}

/// Adds occupied and unknown space, as add_plan() does.
void add_space(const occupancy_t& map, std::size_t max_voxels, Scene* scene) {
  if (map.frame != scene->cloud.frame) return;
  auto block = read_octree(map.data, map.resolution);
  if (!block) return;
  scene->voxels = layers_of(std::move(*block), max_voxels);
  const std::string cloud = describe_cloud(map.utime, map.seq, *scene);
  if (!cloud.empty()) scene->notes.push_back("occupied and unknown space is that of " + cloud);
}

}  // namespace

Scene live_scene(const LatestMessages& messages, const FindGripper& find_gripper,
                 const PackLimits& limits, bool cloud_in_world, double unit) {
  Scene scene;
  scene.name = "live";
  auto quadrics = read<bus::QuadricsMessage>(messages.quadrics,
                                             [](const auto& b) { return bus::decode_quadrics(b); });
  auto cloud = find_cloud(messages.clouds, quadrics, unit);
  const SceneFrames frames = frames_of(messages, cloud, quadrics, cloud_in_world);
  if (!cloud && quadrics) scene.warnings.push_back(explain_absent_cloud(messages));
  add_cloud(std::move(cloud), messages, frames, &scene);
  if (quadrics) add_quadrics(std::move(*quadrics), messages, &scene);
  add_surroundings(messages, frames, &scene);
  if (const auto grasps = read_grasps(messages.grasps)) {
    add_plan(*grasps, find_gripper, limits.grasps, &scene);
  }
  const auto map =
      read<occupancy_t>(messages.occupancy, [](const auto& b) { return bus::decode_occupancy(b); });
  if (map) add_space(*map, limits.voxels, &scene);
  return scene;
}

std::optional<Scene> scene_of_answer(const Bytes& bytes, const FindGripper& find_gripper,
                                     const PackLimits& limits) {
  const auto grasps = read_grasps(bytes);
  if (!grasps) return std::nullopt;
  Scene scene;
  scene.utime = grasps->utime;
  scene.seq = grasps->seq;
  scene.cloud.frame = grasps->frame;
  add_grasps(*grasps, find_gripper, limits.grasps, &scene);
  return scene;
}

}  // namespace quadrille::view

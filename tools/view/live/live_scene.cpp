#include "view/live/live_scene.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/occupancy_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/setting.hpp"
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
std::optional<bus::CloudMessage> find_cloud(const std::deque<Bytes>& clouds,
                                            const std::optional<bus::QuadricsMessage>& quadrics) {
  for (auto bytes = clouds.rbegin(); bytes != clouds.rend(); ++bytes) {
    const auto stamp = bus::read_stamp(**bytes);
    if (!stamp) continue;
    if (quadrics && (stamp->utime != quadrics->utime || stamp->seq != quadrics->seq)) continue;
    const auto decode = [](const auto& b) {
      return bus::decode_cloud(b, bus::kMaxMessageBytes, bus::CloudColours::kKeep);
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

/// Returns which of the shown detections a grasp belongs to; 0 if that is unknown.
int target_of(const Grasp& grasp, bool same_cloud, const Scene& scene) {
  if (same_cloud) return grasp.target;
  const auto found =
      std::find_if(scene.detections.begin(), scene.detections.end(),
                   [&](const Detection& d) { return grasp.track > 0 && d.track == grasp.track; });
  return found == scene.detections.end() ? 0 : found->id;
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
  scene->warnings.insert(scene->warnings.end(), message.warnings.begin(), message.warnings.end());
}

/// Returns the boxes or bodies of the quadrics: the newest, or the ones before them if the quadrics
/// of the newest have not come yet.
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
  const auto bodies =
      find_of<bus::BodiesMessage>(message, messages.bodies, messages.bodies_before,
                                  [](const auto& b) { return bus::decode_bodies(b); });
  if (bodies) scene->lumps = lumps_of(bodies->bodies);
  scene->utime = message.utime;
  scene->seq = message.seq;
  scene->detections = std::move(message.detections);
  std::erase_if(scene->detections, [](const Detection& d) { return !is_reported(d); });
}

/// Adds the cloud, unless it is in another frame than the quadrics; then only the quadrics are
/// shown.
void add_cloud(std::optional<bus::CloudMessage> cloud,
               const std::optional<bus::QuadricsMessage>& quadrics, Scene* scene) {
  if (quadrics) scene->cloud.frame = quadrics->frame;
  if (!cloud) return;
  if (quadrics && quadrics->frame != cloud->cloud.frame) {
    scene->warnings.push_back("the cloud is not shown: it is in frame '" + cloud->cloud.frame +
                              "', the quadrics in '" + quadrics->frame + "'");
    return;
  }
  scene->utime = cloud->utime;
  scene->seq = cloud->seq;
  scene->cloud = std::move(cloud->cloud);
}

}  // namespace

Scene live_scene(const LatestMessages& messages, const FindGripper& find_gripper,
                 const PackLimits& limits) {
  Scene scene;
  scene.name = "live";
  auto quadrics = read<bus::QuadricsMessage>(messages.quadrics,
                                             [](const auto& b) { return bus::decode_quadrics(b); });
  add_cloud(find_cloud(messages.clouds, quadrics), quadrics, &scene);
  const std::string frame = scene.cloud.frame;
  if (quadrics) add_quadrics(std::move(*quadrics), messages, &scene);
  const auto grasps = read_grasps(messages.grasps);
  if (grasps && grasps->frame == frame) add_grasps(*grasps, find_gripper, limits.grasps, &scene);
  const auto map =
      read<occupancy_t>(messages.occupancy, [](const auto& b) { return bus::decode_occupancy(b); });
  if (!map || map->frame != frame) return scene;
  if (auto block = read_octree(map->data, map->resolution)) {
    scene.voxels = layers_of(std::move(*block), limits.voxels);
  }
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

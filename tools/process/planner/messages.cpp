#include "process/planner/messages.hpp"

#include <octomap/OcTree.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "io/planner/octree_file.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille {
namespace {

template <class Message>
Message make_stamped(const Stamp& stamp) {
  Message m;
  m.utime = stamp.utime;
  m.seq = stamp.seq;
  m.frame = stamp.frame;
  return m;
}

template <class Element>
std::int32_t count(const std::vector<Element>& elements) {
  return static_cast<std::int32_t>(elements.size());
}

count_t make_count(std::string_view name, int number) {
  count_t m;
  m.name = name;
  m.count = number;
  return m;
}

target_outcome_t to_message(const TargetOutcome& outcome) {
  target_outcome_t m;
  m.target = outcome.target;
  m.num_grasps = outcome.grasps;
  if (const std::optional<Refusal> why = furthest(outcome.refusals)) m.furthest = to_string(*why);
  for (const auto& [why, number] : outcome.refusals) {
    m.rejected.push_back(make_count(to_string(why), number));
  }
  m.num_rejected = count(m.rejected);
  return m;
}

remedy_t to_message(const Remedy& remedy) {
  remedy_t m;
  m.target = remedy.target;
  m.change = remedy.change;
  m.num_grasps = remedy.grasps;
  m.score = remedy.score;
  return m;
}

look_t to_message(const Look& look) {
  look_t m;
  m.pose = bus::to_message(look.X_CK);
  m.bodies.assign(look.bodies.begin(), look.bodies.end());
  m.num_bodies = count(m.bodies);
  m.gain = look.gain;
  return m;
}

}  // namespace

grasp_t to_message(const Grasp& grasp) {
  grasp_t m;
  m.target = grasp.target;
  m.track = grasp.track;
  m.kind = static_cast<std::int8_t>(grasp.kind);
  m.pregrasp = m.retreat = bus::to_message(grasp.pregrasp());
  m.score = grasp.score;
  m.pose = bus::to_message(grasp.X_CG);
  m.width = grasp.width;
  m.preshape = grasp.preshape;
  for (int i = 0; i < 2; ++i) std::copy_n(grasp.contacts_C[i].data(), 3, m.contacts[i]);
  m.approach = grasp.approach;
  m.friction_needed = grasp.friction_needed;
  m.epsilon = grasp.epsilon;
  m.clearance = grasp.clearance;
  m.unknown_contact = grasp.unknown_contact;
  return m;
}

collision_shape_t to_message(const CollisionShape& shape) {
  collision_shape_t m;
  m.target = shape.target;
  m.kind = shape.kind;
  m.pose = bus::to_message(shape.X_CS);
  m.dimensions = shape.dimensions;
  m.num_dimensions = count(m.dimensions);
  for (const Eigen::Vector3d& p_SV : shape.vertices_S) {
    m.vertices.push_back({p_SV.x(), p_SV.y(), p_SV.z()});
  }
  m.num_vertices = count(m.vertices);
  m.faces.assign(shape.faces.begin(), shape.faces.end());
  m.num_faces = count(m.faces);
  return m;
}

grasps_t make_grasps_message(const Stamp& stamp, const GraspPlan& plan,
                             const PlannerSettings& settings) {
  auto m = make_stamped<grasps_t>(stamp);
  m.request_id = stamp.request_id;
  m.gripper = settings.gripper.name;
  m.unknown = to_string(settings.plan.unknown);
  for (const Grasp& grasp : plan.grasps) m.grasps.push_back(to_message(grasp));
  m.num_grasps = count(m.grasps);
  for (const auto& [reason, number] : plan.rejected) {
    m.rejected.push_back(make_count(reason, number));
  }
  m.num_rejected = count(m.rejected);
  for (const TargetOutcome& outcome : plan.targets) m.targets.push_back(to_message(outcome));
  m.num_targets = count(m.targets);
  for (const Remedy& remedy : plan.remedies) m.remedies.push_back(to_message(remedy));
  m.num_remedies = count(m.remedies);
  for (const Look& look : plan.looks) m.looks.push_back(to_message(look));
  m.num_looks = count(m.looks);
  m.warnings = plan.warnings;
  m.num_warnings = count(m.warnings);
  return m;
}

collision_shapes_t make_shapes_message(const Stamp& stamp, const GraspPlan& plan) {
  auto m = make_stamped<collision_shapes_t>(stamp);
  for (const CollisionShape& shape : plan.shapes) m.shapes.push_back(to_message(shape));
  m.num_shapes = count(m.shapes);
  return m;
}

occupancy_t make_occupancy_message(const Stamp& stamp, const OccupancyGrid* space) {
  auto m = make_stamped<occupancy_t>(stamp);
  m.resolution = 0.0;
  m.num_occupied = m.num_free = 0;
  m.data_size = 0;
  if (!space) return m;
  const std::shared_ptr<const octomap::OcTree> made = space->to_octree();
  const octomap::OcTree& tree = *made;
  m.resolution = tree.getResolution();
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    ++(tree.isNodeOccupied(*leaf) ? m.num_occupied : m.num_free);
  }
  const std::string bytes = io::octree_bytes(tree);
  m.data.assign(bytes.begin(), bytes.end());
  m.data_size = count(m.data);
  return m;
}

}  // namespace quadrille

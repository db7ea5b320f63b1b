#include "targets/target.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "body/find_shell.hpp"
#include "contacts/rim.hpp"
#include "space/support.hpp"
#include "targets/point_noise.hpp"

namespace quadrille {
namespace {

// A slanted box, or a body of uncertain size, may in truth be narrower than its smallest size. A
// target up to this many times as wide as the largest opening is therefore still tried.
constexpr double kMaxWidthToOpening = 1.5;
// Hollow things, and things of unknown shape, that are larger than this are furniture [m].
constexpr double kMaxTableware = 0.4;
// Half the least size of the box around a body: a single face has no thickness [m].
constexpr double kMinHalf = 0.001;

bool graspable(const Body& body, const Gripper& gripper) {
  return body.bounds_Q().sizes().minCoeff() < gripper.max_opening * kMaxWidthToOpening;
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

bool is_wanted_type(QuadricType type, const PlanOptions& options) {
  const std::vector<QuadricType>& types = options.targets;
  return types.empty() || std::find(types.begin(), types.end(), type) != types.end();
}

bool is_face(int id, const Box& box) { return contains(box.faces, id); }

/// Returns true if the target is the body or one of its parts.
bool is_of(const Target& target, const SceneBody& body) {
  return target.id == body.id || contains(body.parts, target.id);
}

/// Bodies may come from messages, so their fields are checked.
bool is_sound(const SceneBody& body) {
  return body.size.allFinite() && body.size.minCoeff() >= 0.0 && body.X_CB.matrix().allFinite() &&
         body.X_CB.linear().isUnitary(1e-3);
}

/// Returns the box around the seen part of a body.
Body box_around(const SceneBody& body) {
  Body box;
  box.profile = Body::Profile::kBox;
  box.X_CQ = body.X_CB;
  const Eigen::Vector3d half = (0.5 * body.size).cwiseMax(kMinHalf);
  box.a = half.x();
  box.b = half.y();
  box.z_max = half.z();
  box.z_min = -half.z();
  return box;
}

/// Finds the wall of a hollow target, such as a cup, and the contact lines across its rim at which
/// points measured the wall.
/// @return number of contact lines at which no points did
int find_rim(const CloudRuns& cloud, std::span<const DepthView> views, const Gripper& gripper,
             const PlanOptions& options, bool inside, Target& target) {
  if (target.body.bounds_Q().sizes().maxCoeff() > kMaxTableware) return 0;
  target.shell = find_shell(target.body, inside, cloud, views, target.up_C(),
                            {options.min_wall, options.max_wall});
  if (!target.shell) return 0;
  const std::vector<ContactLine> lines = rim_lines(*target.shell, gripper);
  target.rim = measured_lines(*target.shell, gripper, lines, cloud);
  return static_cast<int>(lines.size() - target.rim.size());
}

}  // namespace

bool is_wanted(const Detection& detection, const PlanOptions& options) {
  return is_reported(detection) && is_wanted_type(detection.type, options);
}

Eigen::Vector3d Target::up_C() const {
  return supports.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : supports.front().n_C();
}

ChosenTargets choose_targets(const CloudRuns& cloud, const std::vector<Detection>& detections,
                             std::span<const DepthView> views, const Gripper& gripper,
                             const PlanOptions& options, const Deadline& deadline) {
  ChosenTargets chosen;
  for (const Detection& d : detections) {
    if (d.type == QuadricType::kPlane) continue;
    const std::optional<Body> body = make_body(d);
    if (!body) continue;
    if (deadline.passed()) {
      if (is_wanted(d, options)) chosen.refused.emplace(d.id, Refusal::kDeadline);
      continue;
    }
    Target target;
    target.id = d.id;
    target.type = d.type;
    target.track = d.track;
    target.confidence = d.score;
    target.body = *body;
    target.supports = supports_of(*body, detections);
    target.wanted = is_wanted(d, options);
    const bool inside = seen_from_inside(d, *body);
    target.unmeasured = find_rim(cloud, views, gripper, options, inside, target);
    if (target.wanted) chosen.unmeasured += target.unmeasured;
    // A body that was seen from inside is not solid: it can be held only by its wall.
    target.solid = !inside && graspable(*body, gripper);
    if (target.solid || target.shell) {
      target.noise = point_noise(d, cloud);
      chosen.targets.push_back(std::move(target));
    } else if (is_wanted(d, options)) {
      chosen.refused.emplace(d.id, inside ? Refusal::kSeenFromInside : Refusal::kWidth);
    }
  }
  return chosen;
}

ChosenTargets choose_boxes(const CloudRuns& cloud, const std::vector<Box>& boxes,
                           const std::vector<Detection>& detections, const Gripper& gripper,
                           const PlanOptions& options, const Deadline& deadline) {
  ChosenTargets chosen;
  for (const Box& box : boxes) {
    // A box does not stand on its own faces.
    std::vector<Detection> faces, others;
    std::partition_copy(detections.begin(), detections.end(), std::back_inserter(faces),
                        std::back_inserter(others),
                        [&](const Detection& d) { return is_face(d.id, box); });
    // A box may have been found without detected faces.
    const bool wanted = faces.empty()
                            ? is_reported(box) && is_wanted_type(QuadricType::kPlane, options)
                            : std::any_of(faces.begin(), faces.end(), [&](const Detection& face) {
                                return is_wanted(face, options);
                              });
    const Body body = make_body(box);
    if (deadline.passed()) {
      if (wanted) chosen.refused.emplace(box.id, Refusal::kDeadline);
    } else if (graspable(body, gripper)) {
      Target& target = chosen.targets.emplace_back();
      target.id = box.id;
      target.confidence = box.score;
      target.body = body;
      for (const Detection& face : faces) {
        target.noise = std::max(target.noise, point_noise(face, cloud));
      }
      target.supports = supports_of(body, others);
      target.wanted = wanted;
      target.box = box;
    } else if (wanted) {
      chosen.refused.emplace(box.id, Refusal::kWidth);
    }
  }
  return chosen;
}

std::vector<Target> choose_unshaped(const std::vector<SceneBody>& bodies,
                                    const std::vector<Target>& targets,
                                    const std::vector<Detection>& detections,
                                    const PlanOptions& options) {
  std::vector<Target> unshaped;
  for (const SceneBody& body : bodies) {
    const auto is_body = [&](const Target& target) { return is_of(target, body); };
    if (std::any_of(targets.begin(), targets.end(), is_body)) continue;
    if (!is_sound(body) || body.size.maxCoeff() > kMaxTableware) continue;
    std::vector<Detection> others;
    std::copy_if(detections.begin(), detections.end(), std::back_inserter(others),
                 [&](const Detection& d) { return !contains(body.parts, d.id); });
    Target& target = unshaped.emplace_back();
    target.id = body.id;
    target.body = box_around(body);
    target.supports = supports_of(target.body, others);
    target.wanted = options.targets.empty();
    target.solid = false;
    target.whole = body.kind == BodyKind::kLump;
  }
  return unshaped;
}

void add_bodies(const std::vector<SceneBody>& bodies, const std::vector<Detection>& detections,
                std::vector<Target>* targets) {
  for (Target& target : *targets) {
    target.body_id = target.id;
    for (const SceneBody& body : bodies) {
      if (!is_of(target, body)) continue;
      target.body_id = body.id;
      target.body_track = body.track;
    }
    if (target.track == 0) target.track = target.body_track;
    const auto main = std::find_if(detections.begin(), detections.end(),
                                   [&](const Detection& d) { return d.id == target.body_id; });
    target.main_track = main == detections.end() ? target.body_track : main->track;
  }
}

double hand_reach(const Gripper& gripper, double approach) {
  const double back = gripper.finger.z() +
                      gripper.max_extension(gripper.min_opening, gripper.max_opening) +
                      gripper.palm.z() + approach;
  return Eigen::Vector2d(back, 0.5 * gripper.palm.head<2>().norm()).norm();
}

Eigen::AlignedBox3d around(const Body& body, double distance) {
  Eigen::AlignedBox3d box = body.bounds_C();
  box.min().array() -= distance;
  box.max().array() += distance;
  return box;
}

}  // namespace quadrille

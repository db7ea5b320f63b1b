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
// Larger hollows are not tableware [m].
constexpr double kMaxShell = 0.4;

bool graspable(const Body& body, const Gripper& gripper) {
  return body.bounds_Q().sizes().minCoeff() < gripper.max_opening * kMaxWidthToOpening;
}

bool is_face(int id, const Box& box) {
  return std::find(box.faces.begin(), box.faces.end(), id) != box.faces.end();
}

/// Finds the wall of a hollow target, such as a cup, and the contact lines across its rim at which
/// points measured the wall.
/// @return number of contact lines at which no points did
int find_rim(const PointCloud& cloud, const DepthView& view, const Gripper& gripper,
             const PlanOptions& options, bool inside, Target& target) {
  if (target.body.bounds_Q().sizes().maxCoeff() > kMaxShell) return 0;
  target.shell = find_shell(target.body, inside, cloud, view, target.up_C(),
                            {options.min_wall, options.max_wall});
  if (!target.shell) return 0;
  const std::vector<ContactLine> lines = rim_lines(*target.shell, gripper);
  target.rim = measured_lines(*target.shell, gripper, lines, cloud);
  return static_cast<int>(lines.size() - target.rim.size());
}

}  // namespace

bool is_wanted(const Detection& detection, const PlanOptions& options) {
  const std::vector<QuadricType>& types = options.targets;
  return is_reported(detection) &&
         (types.empty() || std::find(types.begin(), types.end(), detection.type) != types.end());
}

Eigen::Vector3d Target::up_C() const {
  return supports.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : supports.front().n_C();
}

ChosenTargets choose_targets(const PointCloud& cloud, const std::vector<Detection>& detections,
                             const DepthView& view, const Gripper& gripper,
                             const PlanOptions& options, const Deadline& deadline) {
  ChosenTargets chosen;
  for (const Detection& d : detections) {
    if (d.type == QuadricType::kPlane) continue;
    const std::optional<Body> body = make_body(d);
    if (!body) continue;
    if (deadline.passed()) {
      if (is_wanted(d, options)) chosen.refuse(d.id, Refusal::kDeadline);
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
    target.unmeasured = find_rim(cloud, view, gripper, options, inside, target);
    if (target.wanted) chosen.refusals[Refusal::kUnmeasured] += target.unmeasured;
    // A body that was seen from inside is not solid: it can be held only by its wall.
    target.solid = !inside && graspable(*body, gripper);
    if (target.solid || target.shell) {
      target.noise = point_noise(d, cloud);
      chosen.targets.push_back(std::move(target));
    } else if (is_wanted(d, options)) {
      chosen.refuse(d.id, inside ? Refusal::kSeenFromInside : Refusal::kWidth);
    }
  }
  return chosen;
}

ChosenTargets choose_boxes(const PointCloud& cloud, const std::vector<Box>& boxes,
                           const std::vector<Detection>& detections, const Gripper& gripper,
                           const PlanOptions& options, const Deadline& deadline) {
  ChosenTargets chosen;
  for (const Box& box : boxes) {
    // A box does not stand on its own faces.
    std::vector<Detection> faces, others;
    std::partition_copy(detections.begin(), detections.end(), std::back_inserter(faces),
                        std::back_inserter(others),
                        [&](const Detection& d) { return is_face(d.id, box); });
    const bool wanted = std::any_of(faces.begin(), faces.end(), [&](const Detection& face) {
      return is_wanted(face, options);
    });
    const Body body = make_body(box);
    if (deadline.passed()) {
      if (wanted) chosen.refuse(box.id, Refusal::kDeadline);
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
      chosen.refuse(box.id, Refusal::kWidth);
    }
  }
  return chosen;
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

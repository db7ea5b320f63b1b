#include "contacts/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contacts/directions.hpp"
#include "contacts/wall_hold.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {
namespace {

// Cosines of the widest angles of approach: 107° to the line of sight, beyond which the hand is in
// the shadow; 60° to straight down; 45° into a mouth, as far as a wall leans. No approach points
// upward by more than 20°, where the palm would be in the support.
constexpr double kMinFromView = -0.3, kMinFromAbove = 0.5, kMinIntoMouth = 0.7, kMaxUpward = 0.35;

// Into a mouth, approaches straight along the wall are tried too, and at this angle to it [rad]:
// half a step of the directions around a line.
constexpr double kBesideWall = 0.13;
// The steepest approach of a line is sampled too if its sine exceeds this: flatter ones do not come
// from above.
constexpr double kMinSteepSine = 0.5;
// If the line of sight is so nearly parallel to the contact line, no side is nearest to the sensor.
constexpr double kMinAcross = 0.1;
// Approaches are sampled every 15°.
constexpr int kApproaches = 24;

double prior(const ContactLine& line, const Eigen::Vector3d& approach, const ApproachSpace& space) {
  const double across = 1.0 - std::abs(line.closing_C.dot(space.view_C));
  const double from = std::max(-approach.dot(space.view_C), -approach.dot(space.up_C));
  const double off = (line.centre_C - space.centre_C).norm() / space.reach;
  const double into = space.into_C.isZero() ? 0.0 : 2.0 * approach.dot(space.into_C);
  return 0.5 * across + 0.3 * from - 0.2 * std::min(off, 1.0) + into;
}

/// Returns the direction across a line that is nearest to the line of sight. If the line of sight
/// runs along the line, an axis of the target decides instead.
Eigen::Vector3d from_view(const Eigen::Vector3d& d, const ApproachSpace& space) {
  Eigen::Vector3d first = -space.view_C + d * d.dot(space.view_C);
  if (first.norm() < kMinAcross) {
    int axis = 0;
    (space.axes_C.transpose() * d).cwiseAbs().minCoeff(&axis);
    first = d.cross(space.axes_C.col(axis));
  }
  return first.normalized();
}

/// Returns all directions that are tried around a line, reachable or not.
std::vector<Eigen::Vector3d> approaches(const ContactLine& line, const ApproachSpace& space) {
  const Eigen::Vector3d& d = line.closing_C;
  std::vector<Eigen::Vector3d> directions = around_closing(d, from_view(d, space));
  const Eigen::Vector3d down = d * d.dot(space.up_C) - space.up_C;
  if (down.norm() > kMinSteepSine) directions.push_back(down.normalized());
  if (!space.into_C.isZero()) {
    const Eigen::Vector3d along = along_wall(line, space.into_C), beside = d.cross(along);
    for (const double turn : {0.0, kBesideWall, -kBesideWall}) {
      directions.emplace_back(std::cos(turn) * along + std::sin(turn) * beside);
    }
  }
  if (space.wanted) {
    const Eigen::Vector3d& axis = space.wanted->axis_C;
    const Eigen::Vector3d nearest = axis - d * d.dot(axis);
    if (nearest.norm() > kMinAcross) directions.push_back(nearest.normalized());
  }
  return directions;
}

}  // namespace

bool wanted(const Eigen::Vector3d& approach, const ApproachSpace& space) {
  return !space.wanted || space.wanted->contains(approach);
}

bool reachable(const Eigen::Vector3d& approach, const ApproachSpace& space) {
  if (approach.dot(space.up_C) > kMaxUpward) return false;
  if (!space.into_C.isZero() && approach.dot(space.into_C) < kMinIntoMouth) return false;
  return -approach.dot(space.view_C) > kMinFromView || -approach.dot(space.up_C) > kMinFromAbove;
}

std::vector<Eigen::Vector3d> around_closing(const Eigen::Vector3d& closing,
                                            const Eigen::Vector3d& first) {
  return fan(first, closing.cross(first), kApproaches, 2.0 * std::numbers::pi);
}

SampledApproaches sample_approaches(const std::vector<ContactLine>& lines,
                                    const ApproachSpace& space) {
  SampledApproaches sampled;
  std::vector<GraspCandidate> best_first;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    for (const Eigen::Vector3d& approach : approaches(lines[n], space)) {
      if (!wanted(approach, space)) {
        ++sampled.unwanted;
      } else if (reachable(approach, space)) {
        best_first.push_back({static_cast<int>(n), approach, prior(lines[n], approach, space)});
      } else {
        ++sampled.unreachable;
      }
    }
  }
  std::stable_sort(
      best_first.begin(), best_first.end(),
      [](const GraspCandidate& a, const GraspCandidate& b) { return a.prior > b.prior; });
  sampled.candidates.reserve(best_first.size());
  visit_in_passes(best_first.begin(), best_first.end(), [&](const GraspCandidate& candidate) {
    sampled.candidates.push_back(candidate);
  });
  return sampled;
}

Eigen::Isometry3d grasp_pose(const ContactLine& line, const Eigen::Vector3d& approach_C,
                             double depth) {
  Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
  X_CG.linear().col(0) = line.closing_C.cross(approach_C);
  X_CG.linear().col(1) = line.closing_C;
  X_CG.linear().col(2) = approach_C;
  X_CG.translation() = line.centre_C + depth * approach_C;
  return rounded(X_CG);
}

}  // namespace quadrille

#include "contacts/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contacts/wall_hold.hpp"

namespace quadrille {

namespace {

// Cosines of the widest angles: 107° to the line of sight, beyond which the hand is in the shadow;
// 60° to straight down; 45° into a mouth, as far as a wall leans; and never steeper up than 20°,
// where the palm would be in what the target stands on.
constexpr double kFromView = -0.3, kFromAbove = 0.5, kIntoMouth = 0.7, kUpward = 0.35;

// Into a mouth also straight along the wall, and this far beside it [rad]: half a step of the
// directions around a line.
constexpr double kBesideWall = 0.13;
// The steepest approach of a line is sampled too if its sine is more than this: flatter ones are
// not from above.
constexpr double kSteep = 0.5;

double prior(const ContactLine& line, const Eigen::Vector3d& approach, const ApproachSpace& space) {
  const double across = 1.0 - std::abs(line.closing_C.dot(space.view_C));
  const double from = std::max(-approach.dot(space.view_C), -approach.dot(space.up_C));
  const double off = (line.centre_C - space.centre_C).norm() / space.reach;
  const double into = space.into_C.isZero() ? 0.0 : 2.0 * approach.dot(space.into_C);
  return 0.5 * across + 0.3 * from - 0.2 * std::min(off, 1.0) + into;
}

// Every kStride-th first, then those between: the best ones are much alike, and where one is
// blocked so are its neighbours.
std::vector<GraspCandidate> spread_out(const std::vector<GraspCandidate>& best_first) {
  constexpr std::size_t kStride = 16;
  std::vector<GraspCandidate> spread;
  spread.reserve(best_first.size());
  for (std::size_t start = 0; start < kStride; ++start) {
    for (std::size_t n = start; n < best_first.size(); n += kStride) {
      spread.push_back(best_first[n]);
    }
  }
  return spread;
}

}  // namespace

bool reachable(const Eigen::Vector3d& approach, const ApproachSpace& space) {
  if (approach.dot(space.up_C) > kUpward) return false;
  if (!space.into_C.isZero() && approach.dot(space.into_C) < kIntoMouth) return false;
  return -approach.dot(space.view_C) > kFromView || -approach.dot(space.up_C) > kFromAbove;
}

std::vector<GraspCandidate> sample_approaches(const std::vector<ContactLine>& lines,
                                              const ApproachSpace& space, int& refused) {
  constexpr int kDirections = 24;
  std::vector<GraspCandidate> candidates;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const Eigen::Vector3d& d = lines[n].closing_C;
    Eigen::Vector3d first = -space.view_C + d * d.dot(space.view_C);
    if (first.norm() < 0.1) {
      int least = 0;
      (space.axes_C.transpose() * d).cwiseAbs().minCoeff(&least);
      first = d.cross(space.axes_C.col(least));
    }
    first.normalize();
    const Eigen::Vector3d second = d.cross(first);
    const auto offer = [&](const Eigen::Vector3d& approach) {
      if (reachable(approach, space)) {
        candidates.push_back({static_cast<int>(n), approach, prior(lines[n], approach, space)});
      } else {
        ++refused;
      }
    };
    for (int k = 0; k < kDirections; ++k) {
      const double t = 2.0 * std::numbers::pi * k / kDirections;
      offer(std::cos(t) * first + std::sin(t) * second);
    }
    const Eigen::Vector3d down = d * d.dot(space.up_C) - space.up_C;
    if (down.norm() > kSteep) offer(down.normalized());
    if (!space.into_C.isZero()) {
      const Eigen::Vector3d along = along_wall(lines[n], space.into_C), beside = d.cross(along);
      for (const double turn : {0.0, kBesideWall, -kBesideWall}) {
        offer(std::cos(turn) * along + std::sin(turn) * beside);
      }
    }
  }
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const GraspCandidate& a, const GraspCandidate& b) { return a.prior > b.prior; });
  return spread_out(candidates);
}

Eigen::Isometry3d grasp_pose(const ContactLine& line, const Eigen::Vector3d& approach_C,
                             double depth) {
  Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
  X_CG.linear().col(0) = line.closing_C.cross(approach_C);
  X_CG.linear().col(1) = line.closing_C;
  X_CG.linear().col(2) = approach_C;
  X_CG.translation() = line.centre_C + depth * approach_C;
  return X_CG;
}

}  // namespace quadrille

#include "search/hypotheses.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "fit/half_gradient.hpp"
#include "search/basis.hpp"
#include "search/sphere_vote.hpp"
#include "search/vote.hpp"

namespace quadrille {
namespace {

// A sphere of less curvature, in a neighbourhood of unit size, passes for a plane.
constexpr double kMinCurvature = 0.2;

std::vector<Eigen::Matrix4d> through_three(const OrientedPointsf& points,
                                           const VoteOptions& options, RandomStream& random) {
  std::array<OrientedPoint, 3> basis;
  for (OrientedPoint& point : basis) point = draw_point(points, random);
  if (inconsistency(basis) > kMaxInconsistency) return {};
  const std::optional<Pencil> pencil = make_pencil(basis);
  if (!pencil) return {};
  std::vector<Eigen::Matrix4d> list;
  for (const VotePeak& peak : vote(*pencil, points, options)) {
    list.push_back(pencil->at(peak.lambda));
  }
  return list;
}

std::vector<Eigen::Matrix4d> spheres_through_one(const OrientedPointsf& points,
                                                 const VoteOptions& options, RandomStream& random) {
  const OrientedPoint basis = draw_point(points, random);
  std::vector<Eigen::Matrix4d> list;
  for (const VotePeak& peak : vote_curvature(basis, points, options)) {
    if (std::abs(peak.lambda) < kMinCurvature) continue;
    list.push_back(tangent_sphere(basis, peak.lambda));
  }
  return list;
}

}  // namespace

OrientedPoint draw_point(const OrientedPointsf& points, RandomStream& random) {
  return points.at(random.below(static_cast<int>(points.size())));
}

std::vector<Eigen::Matrix4d> draw_hypotheses(BasisKind kind, const OrientedPointsf& points,
                                             const VoteOptions& options, RandomStream& random) {
  return kind == BasisKind::kSphere ? spheres_through_one(points, options, random)
                                    : through_three(points, options, random);
}

int count_support(const OrientedPointsf& p, const Eigen::Matrix4d& Q, float distance,
                  float min_cosine) {
  const HalfGradients g(p, Q);
  Eigen::ArrayXf slope = g.x().square() + g.y().square() + g.z().square();
  // Eigen's roots of vectors start from an estimate of the processor, which differs between makers.
  for (float& s : slope) s = std::sqrt(s);
  return static_cast<int>((g.f().abs() <= 2.0f * distance * slope &&
                           g.x() * p.nx() + g.y() * p.ny() + g.z() * p.nz() >= min_cosine * slope)
                              .count());
}

Hypothesis supported(const Voters& voters, const Eigen::Matrix4d& Q) {
  return {Q, count_support(voters.points, Q, voters.max_distance,
                           static_cast<float>(voters.vote.min_cosine))};
}

Hypothesis propose(const Voters& voters, BasisKind kind, int bases, RandomStream& random) {
  Hypothesis best;
  for (int trial = 0; trial < bases; ++trial) {
    for (const Eigen::Matrix4d& Q : draw_hypotheses(kind, voters.points, voters.vote, random)) {
      const Hypothesis hypothesis = supported(voters, Q);
      if (hypothesis.support > best.support) best = hypothesis;
    }
  }
  return best;
}

}  // namespace quadrille

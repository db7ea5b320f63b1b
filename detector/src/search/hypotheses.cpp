#include "search/hypotheses.hpp"

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <optional>

#include "fit/half_gradient.hpp"
#include "fit/monomials.hpp"
#include "quadrille/detector/quadric.hpp"
#include "search/basis.hpp"
#include "search/cone_basis.hpp"
#include "search/cylinder_basis.hpp"
#include "search/gradient_scales.hpp"
#include "search/sphere_vote.hpp"
#include "search/web_vote.hpp"

namespace quadrille {
namespace {

// A basis farther than this from lying on one quadric is not voted on; see inconsistency().
constexpr double kMaxInconsistency = 0.6;
// Assumed error of the samples' normals [rad].
constexpr double kNormalNoise = 0.05;
// A sphere of less curvature, in a neighbourhood of unit size, passes for a plane.
constexpr double kMinCurvature = 0.2;

int draw_index(const OrientedPointsf& voters, RandomStream& random) {
  return random.below(static_cast<int>(voters.size()));
}

OrientedPoint draw(const OrientedPointsf& voters, RandomStream& random) {
  const int k = draw_index(voters, random);
  return voters.at(k);
}

std::optional<Pencil> draw_pencil(const OrientedPointsf& voters, GradientLengths lengths,
                                  RandomStream& random, BasisMemory* memory = nullptr) {
  std::array<OrientedPoint, 3> basis;
  std::array<int, 3> which;
  for (std::size_t i = 0; i < 3; ++i) {
    which[i] = draw_index(voters, random);
    basis[i] = voters.at(which[i]);
  }
  std::optional<Pencil> pencil = lengths == GradientLengths::kSolved
                                     ? make_scaled_pencil(basis, kScaleSoftness)
                                     : make_pencil(basis);
  if (pencil && inconsistency(basis) > kMaxInconsistency) pencil.reset();
  if (!pencil || !memory) return pencil;
  for (int& index : which) index = memory->sample_of_voter[static_cast<std::size_t>(index)];
  if (!memory->triplets.insert(which)) pencil.reset();
  return pencil;
}

std::vector<Eigen::Matrix4d> through_three(const OrientedPointsf& voters,
                                           const VoteOptions& options, RandomStream& random,
                                           BasisMemory* memory) {
  std::vector<Eigen::Matrix4d> list;
  if (const std::optional<Pencil> pencil = draw_pencil(voters, options.lengths, random, memory)) {
    for (const VotePeak& peak : vote(*pencil, voters, options)) {
      list.push_back(pencil->at(peak.lambda));
    }
  }
  return list;
}

std::vector<Eigen::Matrix4d> through_four(const OrientedPointsf& voters, const VoteOptions& options,
                                          RandomStream& random) {
  const std::optional<Pencil> pencil = draw_pencil(voters, options.lengths, random);
  const Eigen::Vector4d x = draw(voters, random).x.homogeneous();
  if (!pencil) return {};
  const double height = pencil->plane.dot(x);
  if (!(std::abs(height) > options.min_height)) return {};
  return {pencil->at(-x.dot(pencil->Q0 * x) / (height * height))};
}

/// The null vector of nine rows vᵀ, with the sign for which its gradient agrees with most of the
/// nine normals.
std::vector<Eigen::Matrix4d> through_nine(const OrientedPointsf& voters, RandomStream& random) {
  std::array<OrientedPoint, 9> basis;
  Eigen::Matrix<double, 10, 9> rows;
  for (int i = 0; i < 9; ++i) {
    basis[i] = draw(voters, random);
    rows.col(i) = monomials(basis[i].x);
  }
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 10, 9>> qr(rows);
  if (qr.rank() < 9) return {};
  const Eigen::Matrix<double, 10, 10> basis_of_rows = qr.householderQ();
  Quadric Q(Eigen::Matrix<double, 10, 1>(basis_of_rows.col(9)));
  double side = 0;
  for (const OrientedPoint& p : basis) side += Q.gradient(p.x).normalized().dot(p.n);
  if (side < 0) Q = Q.flipped();
  return {Q.matrix()};
}

std::vector<Eigen::Matrix4d> through_two(const OrientedPointsf& voters, const VoteOptions& options,
                                         RandomStream& random) {
  const OrientedPoint first = draw(voters, random), second = draw(voters, random);
  std::vector<Eigen::Matrix4d> list;
  if (const std::optional<Web> web = make_web({first, second}, kNormalNoise)) {
    for (const WebPeak& peak : vote(*web, voters, options)) list.push_back(web->at(peak.lambda));
  }
  return list;
}

std::vector<Eigen::Matrix4d> spheres_through_one(const OrientedPointsf& voters,
                                                 const VoteOptions& options, RandomStream& random) {
  const OrientedPoint basis = draw(voters, random);
  std::vector<Eigen::Matrix4d> list;
  for (const VotePeak& peak : vote_curvature(basis, voters, options)) {
    if (std::abs(peak.lambda) < kMinCurvature) continue;
    list.push_back(tangent_sphere(basis, peak.lambda));
  }
  return list;
}

template <std::size_t kPoints>
std::array<OrientedPoint, kPoints> draw_points(const OrientedPointsf& voters,
                                               RandomStream& random) {
  std::array<OrientedPoint, kPoints> points;
  for (OrientedPoint& point : points) point = draw(voters, random);
  return points;
}

std::vector<Eigen::Matrix4d> list_of(const std::optional<Eigen::Matrix4d>& Q) {
  if (!Q) return {};
  return {*Q};
}

}  // namespace

std::vector<Eigen::Matrix4d> draw_hypotheses(BasisKind kind, const OrientedPointsf& voters,
                                             const VoteOptions& options, RandomStream& random,
                                             BasisMemory* memory) {
  switch (kind) {
    case BasisKind::kThreePoints:
      return through_three(voters, options, random, memory);
    case BasisKind::kFourPoints:
      return through_four(voters, options, random);
    case BasisKind::kNinePoints:
      return through_nine(voters, random);
    case BasisKind::kTwoPoints:
      return through_two(voters, options, random);
    case BasisKind::kSphere:
      return spheres_through_one(voters, options, random);
    case BasisKind::kCylinder:
      return list_of(cylinder_through(draw_points<2>(voters, random)));
    case BasisKind::kCone:
      return list_of(cone_through(draw_points<3>(voters, random)));
  }
  return {};
}

int count_support(const OrientedPointsf& p, const Eigen::Matrix4d& Q, float distance,
                  float min_cosine) {
  const HalfGradients g(p, Q);
  const Eigen::ArrayXf slope = (g.x().square() + g.y().square() + g.z().square()).sqrt();
  return static_cast<int>((g.f().abs() <= 2.0f * distance * slope &&
                           g.x() * p.nx() + g.y() * p.ny() + g.z() * p.nz() >= min_cosine * slope)
                              .count());
}

}  // namespace quadrille

#include "search/hypotheses.hpp"

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <optional>

#include "quadrille/detector/quadric.hpp"
#include "search/basis.hpp"
#include "search/quadric_values.hpp"
#include "search/sphere_vote.hpp"
#include "search/web_vote.hpp"

namespace quadrille {
namespace {

// A basis further than this from lying on one quadric is not worth a vote; see inconsistency().
constexpr double kMaxInconsistency = 0.6;
// Normals of samples are known to about this [rad].
constexpr double kNormalNoise = 0.05;
// With less curvature a neighbourhood, of size one, passes for a plane.
constexpr double kMinCurvature = 0.2;

int draw_index(const FitPoints& voters, RandomStream& random) {
  return random.below(static_cast<int>(voters.size()));
}

OrientedPoint draw(const FitPoints& voters, RandomStream& random) {
  const int k = draw_index(voters, random);
  return {voters.point(k), voters.normal(k)};
}

std::optional<Pencil> draw_pencil(const FitPoints& voters, RandomStream& random,
                                  BasisMemory* memory = nullptr) {
  std::array<OrientedPoint, 3> basis;
  std::array<int, 3> which;
  for (std::size_t i = 0; i < 3; ++i) {
    which[i] = draw_index(voters, random);
    basis[i] = {voters.point(which[i]), voters.normal(which[i])};
  }
  std::optional<Pencil> pencil = make_pencil(basis);
  if (pencil && inconsistency(basis) > kMaxInconsistency) pencil.reset();
  if (!pencil || !memory) return pencil;
  for (int& index : which) index = memory->sample_of_voter[static_cast<std::size_t>(index)];
  if (!memory->triplets.insert(which)) pencil.reset();
  return pencil;
}

std::vector<Eigen::Matrix4d> through_three(const FitPoints& voters, const VoteOptions& options,
                                           RandomStream& random, BasisMemory* memory) {
  std::vector<Eigen::Matrix4d> list;
  if (const std::optional<Pencil> pencil = draw_pencil(voters, random, memory)) {
    for (const VotePeak& peak : vote(*pencil, voters, options)) {
      list.push_back(pencil->at(peak.lambda));
    }
  }
  return list;
}

std::vector<Eigen::Matrix4d> through_four(const FitPoints& voters, const VoteOptions& options,
                                          RandomStream& random) {
  const std::optional<Pencil> pencil = draw_pencil(voters, random);
  const Eigen::Vector4d x = draw(voters, random).x.homogeneous();
  if (!pencil) return {};
  const double height = pencil->plane.dot(x);
  if (!(std::abs(height) > options.min_height)) return {};
  return {pencil->at(-x.dot(pencil->Q0 * x) / (height * height))};
}

/// The null vector of nine rows vᵀ, its gradient on the side of most of the nine normals.
std::vector<Eigen::Matrix4d> through_nine(const FitPoints& voters, RandomStream& random) {
  std::array<OrientedPoint, 9> basis;
  Eigen::Matrix<double, 10, 9> rows;
  for (int i = 0; i < 9; ++i) {
    basis[i] = draw(voters, random);
    const double x = basis[i].x.x(), y = basis[i].x.y(), z = basis[i].x.z();
    rows.col(i) << x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z, 2 * x, 2 * y, 2 * z, 1;
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

std::vector<Eigen::Matrix4d> through_two(const FitPoints& voters, const VoteOptions& options,
                                         RandomStream& random) {
  const OrientedPoint first = draw(voters, random), second = draw(voters, random);
  std::vector<Eigen::Matrix4d> list;
  if (const std::optional<Web> web = make_web({first, second}, kNormalNoise)) {
    for (const WebPeak& peak : vote(*web, voters, options)) list.push_back(web->at(peak.lambda));
  }
  return list;
}

std::vector<Eigen::Matrix4d> spheres_through_one(const FitPoints& voters,
                                                 const VoteOptions& options, RandomStream& random) {
  const OrientedPoint basis = draw(voters, random);
  std::vector<Eigen::Matrix4d> list;
  for (const VotePeak& peak : vote_curvature(basis, voters, options)) {
    if (std::abs(peak.lambda) < kMinCurvature) continue;
    list.push_back(tangent_sphere(basis, peak.lambda));
  }
  return list;
}

}  // namespace

std::vector<Eigen::Matrix4d> draw_hypotheses(BasisKind kind, const FitPoints& voters,
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
  }
  return {};
}

int count_support(const FitPoints& p, const Eigen::Matrix4d& matrix, float distance,
                  float min_cosine) {
  const QuadricValues q(matrix.cast<float>(), p);
  const Eigen::ArrayXf slope = (q.gx.square() + q.gy.square() + q.gz.square()).sqrt();
  return static_cast<int>((q.f.abs() <= 2.0f * distance * slope &&
                           q.gx * p.nx + q.gy * p.ny + q.gz * p.nz >= min_cosine * slope)
                              .count());
}

}  // namespace quadrille

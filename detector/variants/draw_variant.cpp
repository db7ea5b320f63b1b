#include "variants/draw_variant.hpp"

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <optional>

#include "fit/monomials.hpp"
#include "quadrille/detector/quadric.hpp"
#include "search/basis.hpp"
#include "search/vote.hpp"
#include "variants/gradient_scales.hpp"
#include "variants/type_bases.hpp"
#include "variants/web_vote.hpp"

namespace quadrille {
namespace {

template <std::size_t kPoints>
std::array<OrientedPoint, kPoints> draw_points(const Voters& voters, RandomStream& random) {
  std::array<OrientedPoint, kPoints> points;
  for (OrientedPoint& point : points) point = draw_point(voters.points, random);
  return points;
}

std::optional<Pencil> draw_pencil(GradientLengths lengths, const Voters& voters,
                                  RandomStream& random, TripletSet* seen = nullptr) {
  std::array<OrientedPoint, 3> basis;
  std::array<int, 3> samples;
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = random.below(static_cast<int>(voters.points.size()));
    basis[i] = voters.points.at(k);
    samples[i] = voters.samples[static_cast<std::size_t>(k)];
  }
  std::optional<Pencil> pencil = lengths == GradientLengths::kSolved
                                     ? make_scaled_pencil(basis, kScaleSoftness)
                                     : make_pencil(basis);
  if (!pencil || inconsistency(basis) > kMaxInconsistency) return std::nullopt;
  if (seen && !seen->insert(samples)) return std::nullopt;
  return pencil;
}

std::vector<Eigen::Matrix4d> through_three(GradientLengths lengths, const Voters& voters,
                                           RandomStream& random, TripletSet* seen) {
  std::vector<Eigen::Matrix4d> list;
  if (const std::optional<Pencil> pencil = draw_pencil(lengths, voters, random, seen)) {
    for (const VotePeak& peak : vote(*pencil, voters.points, voters.vote)) {
      list.push_back(pencil->at(peak.lambda));
    }
  }
  return list;
}

std::vector<Eigen::Matrix4d> through_four(GradientLengths lengths, const Voters& voters,
                                          RandomStream& random) {
  const std::optional<Pencil> pencil = draw_pencil(lengths, voters, random);
  const Eigen::Vector4d x = draw_point(voters.points, random).x.homogeneous();
  if (!pencil) return {};
  const double height = pencil->plane.dot(x);
  if (!(std::abs(height) > voters.vote.min_height)) return {};
  return {pencil->at(-x.dot(pencil->Q0 * x) / (height * height))};
}

/// The null vector of nine rows vᵀ, with the sign for which its gradient agrees with most of the
/// nine normals.
std::vector<Eigen::Matrix4d> through_nine(const Voters& voters, RandomStream& random) {
  const std::array<OrientedPoint, 9> basis = draw_points<9>(voters, random);
  Eigen::Matrix<double, 10, 9> rows;
  for (int i = 0; i < 9; ++i) rows.col(i) = monomials(basis[static_cast<std::size_t>(i)].x);
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 10, 9>> qr(rows);
  if (qr.rank() < 9) return {};
  const Eigen::Matrix<double, 10, 10> basis_of_rows = qr.householderQ();
  Quadric Q(Eigen::Matrix<double, 10, 1>(basis_of_rows.col(9)));
  double side = 0;
  for (const OrientedPoint& p : basis) side += Q.gradient(p.x).normalized().dot(p.n);
  if (side < 0) Q = Q.flipped();
  return {Q.matrix()};
}

std::vector<Eigen::Matrix4d> through_two(const Voters& voters, RandomStream& random) {
  std::vector<Eigen::Matrix4d> list;
  if (const auto web = make_web(draw_points<2>(voters, random), kNormalNoise)) {
    for (const WebPeak& peak : vote(*web, voters.points, voters.vote)) {
      list.push_back(web->at(peak.lambda));
    }
  }
  return list;
}

std::vector<Eigen::Matrix4d> list_of(const std::optional<Eigen::Matrix4d>& Q) {
  if (!Q) return {};
  return {*Q};
}

}  // namespace

int basis_size(VariantBasis basis) {
  switch (basis) {
    case VariantBasis::kTwoPoints:
    case VariantBasis::kCylinder:
      return 2;
    case VariantBasis::kThreePoints:
    case VariantBasis::kCone:
      return 3;
    case VariantBasis::kFourPoints:
      return 4;
    case VariantBasis::kNinePoints:
      return 9;
  }
  return 0;
}

std::vector<Eigen::Matrix4d> draw_variant(const Variant& variant, const Voters& voters,
                                          RandomStream& random, TripletSet* seen) {
  switch (variant.basis) {
    case VariantBasis::kThreePoints:
      return through_three(variant.lengths, voters, random, seen);
    case VariantBasis::kFourPoints:
      return through_four(variant.lengths, voters, random);
    case VariantBasis::kNinePoints:
      return through_nine(voters, random);
    case VariantBasis::kTwoPoints:
      return through_two(voters, random);
    case VariantBasis::kCylinder:
      return list_of(cylinder_through(draw_points<2>(voters, random)));
    case VariantBasis::kCone:
      return list_of(cone_through(draw_points<3>(voters, random)));
  }
  return {};
}

}  // namespace quadrille

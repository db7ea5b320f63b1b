#include "variants/gradient_scales.hpp"

#include <algorithm>
#include <cmath>

#include "detector/fits/examples.hpp"
#include "support/catch.hpp"
#include "variants/draw_variant.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Least |b_ij| of any two of the points.
double least_product(const std::array<OrientedPoint, 3>& basis) {
  double least = 1e9;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i != j) least = std::min(least, std::abs(basis[i].n.dot(basis[j].x - basis[i].x)));
    }
  }
  return least;
}

}  // namespace

TEST_CASE("the lengths of gradients follow from unit normals, for all types and either side",
          "[scales][paper:eq4][law]") {
  RandomStream random(311, 0);
  for (const CanonicalForm& form : curved_forms()) {
    if (is_flat(form.type)) continue;
    CAPTURE(to_string(form.type));
    for (int checked = 0; checked < 20;) {
      const Sampled s = sample(form, 3, random, true);
      const double side = checked % 2 ? 1.0 : -1.0;
      std::array<OrientedPoint, 3> basis = {s.points.at(0), s.points.at(1), s.points.at(2)};
      for (OrientedPoint& p : basis) p.n *= side;
      if (least_product(basis) < 0.01) continue;
      ++checked;
      const auto lengths = gradient_scales(basis, 0.0);
      REQUIRE(lengths);
      const double ratio = (*lengths)[0] / s.Q.gradient(basis[0].x).norm();
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK((*lengths)[i] / ratio == Approx(s.Q.gradient(basis[i].x).norm()).epsilon(1e-9));
      }
      CHECK((*lengths)[0] + (*lengths)[1] + (*lengths)[2] == Approx(3.0));
    }
  }
}

TEST_CASE("the true quadric lies in the pencil of solved lengths, and not in that of a common one",
          "[scales][paper:eq6]") {
  RandomStream random(312, 0);
  const auto gap_to_pencil = [](const Pencil& pencil, const Quadric& Q, const Eigen::Vector3d& at) {
    const Eigen::Vector4d x = at.homogeneous();
    const double z = pencil.plane.dot(x);
    return difference(pencil.at(-x.dot(pencil.Q0 * x) / (z * z)), Q.matrix());
  };
  std::vector<double> common;
  for (int checked = 0; checked < 50;) {
    const Sampled s = sample(curved_forms()[1], 4, random, true);
    const std::array<OrientedPoint, 3> basis = {s.points.at(0), s.points.at(1), s.points.at(2)};
    const auto unit = make_pencil(basis);
    const auto solved = make_scaled_pencil(basis, 0.0);
    if (!unit || std::abs(unit->plane.dot(s.points.at(3).x.homogeneous())) < 0.1) continue;
    ++checked;
    REQUIRE(solved);
    CHECK(gap_to_pencil(*solved, s.Q, s.points.at(3).x) < 1e-9);
    common.push_back(gap_to_pencil(*unit, s.Q, s.points.at(3).x));
  }
  std::sort(common.begin(), common.end());
  CHECK(common[common.size() / 2] > 0.03);
}

TEST_CASE("doubted lengths run from the solved ones to a common one", "[scales]") {
  RandomStream random(313, 0);
  const Sampled s = sample(curved_forms()[1], 3, random, true);
  const std::array<OrientedPoint, 3> basis = {s.points.at(0), s.points.at(1), s.points.at(2)};
  const auto exact = gradient_scales(basis, 0.0);
  const auto trusting = gradient_scales(basis, 1e-6), doubting = gradient_scales(basis, 1e3);
  REQUIRE((exact && trusting && doubting));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((*trusting)[i] == Approx((*exact)[i]).epsilon(1e-6));
    CHECK((*doubting)[i] == Approx(1.0).epsilon(1e-4));
  }
}

TEST_CASE("points of a plane, coinciding points and torn normals have no lengths",
          "[scales][degenerate]") {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  std::array<OrientedPoint, 3> basis = {{{{0, 0, 0}, z}, {{1, 0, 0}, z}, {{0, 1, 0}, z}}};
  CHECK_FALSE(gradient_scales(basis, 0.0));
  // A doubted plane keeps the common scale.
  const auto soft = gradient_scales(basis, 0.2);
  REQUIRE(soft);
  CHECK((*soft)[1] == Approx(1.0));
  basis[1] = basis[0];
  CHECK_FALSE(gradient_scales(basis, 0.2));
  for (int i = 0; i < 3; ++i) basis[i] = {Eigen::Vector3d::Unit(i), Eigen::Vector3d::Unit(i)};
  CHECK(gradient_scales(basis, 0.0));
  basis[1].n *= -1.0;
  CHECK_FALSE(gradient_scales(basis, 0.0));
  basis[2].x.x() = NAN;
  CHECK_FALSE(gradient_scales(basis, 0.0));
}

TEST_CASE("with solved lengths fewer bases find an ellipsoid", "[scales][hypotheses]") {
  RandomStream random(314, 0);
  const OrientedPointsf points =
      to_fit_points(points_on(diagonal(1, 1.8, 5, -1), 200, -1e3, random));
  const Voters voters{points, std::vector<int>(200), 0.03f, {}};
  const auto right_of = [&](GradientLengths lengths) {
    RandomStream draws(315, 0);
    int right = 0;
    for (int k = 0; k < 500; ++k) {
      for (const Eigen::Matrix4d& Q : draw_variant({.lengths = lengths}, voters, draws)) {
        right += count_support(points, Q, 0.03f, 0.9f) > 160;
      }
    }
    return right;
  };
  CHECK(right_of(GradientLengths::kSolved) > 2 * right_of(GradientLengths::kCommon));
}

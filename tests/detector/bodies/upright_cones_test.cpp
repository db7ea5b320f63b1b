#include "bodies/upright_cones.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/surface_fit.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kCupSlope = 0.1;

/// The last fit of the cylinder that suits the seen half of a cup best, which is upright and 72 mm
/// high, then turned about the horizontal axis across the view.
/// @param slope  of its radius along its height, 35 mm in the middle
LastFit cup_as_cylinder(double slope, double lean, double noise, std::uint64_t seed) {
  const Eigen::AngleAxisd turn(lean, Eigen::Vector3d::UnitY());
  const SurfaceSamples samples = surface_grid(
      20, 24,
      [&](int i, int j) {
        const double z = 0.003 * (j - 11.5), angle = 2.4 * (i / 19.0 - 0.5);
        const double r = 0.035 + slope * z;
        const Eigen::Vector3d n =
            Eigen::Vector3d(std::cos(angle), std::sin(angle), -slope).normalized();
        return OrientedPoint{turn * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z),
                             turn * n};
      },
      0.003, noise, seed);
  AggregateOptions only_round;
  only_round.families = {Family::kCylinder};
  const auto surface = fit_surface(samples, all_of(samples), only_round);
  REQUIRE(surface);
  const std::vector<Eigen::Matrix3f> scatter(samples.p.size(), Eigen::Matrix3f::Zero());
  LastFit fit = last_fit(*surface, samples, scatter, {});
  REQUIRE(fit.surface.fit.family == Family::kCylinder);
  fit.surface.evidence.sigma = noise;
  return fit;
}

double lean_of(const Surface& surface) {
  return std::acos(std::min(1.0, std::abs(form_of(surface).X.linear()(2, 2))));
}

}  // namespace

TEST_CASE("a tapered cup that passes for a leaning cylinder becomes an upright cone", "[upright]") {
  std::vector<LastFit> fits = {cup_as_cylinder(kCupSlope, 0.0, 0.001, GENERATE(1, 2, 3))};
  REQUIRE(lean_of(fits[0].surface) > 0.045);
  CHECK(stand_cones_up(Eigen::Vector3d::UnitZ(), &fits) == std::vector{0});
  const Surface& cone = fits[0].surface;
  REQUIRE(form_of(cone).type == QuadricType::kCone);
  CHECK(lean_of(cone) < 1e-6);
  CHECK(std::abs(form_of(cone).dimensions.front().second - std::atan(kCupSlope)) < 0.02);
  // The quadric in frame C is that of the fit: the middle of the wall lies on it.
  const Eigen::Vector3d middle(0.035, 0.0, 0.0);
  CHECK(std::abs(cone.Q.value(middle)) / cone.Q.gradient(middle).norm() < 0.001);
}

TEST_CASE("cylinders stay what they are, upright, leaning or lying", "[upright]") {
  const double lean = GENERATE(0.0, 0.12, 0.5);
  std::vector<LastFit> fits = {cup_as_cylinder(0.0, lean, 0.0003, GENERATE(1, 2, 3))};
  CHECK(stand_cones_up(Eigen::Vector3d::UnitZ(), &fits).empty());
  CHECK(form_of(fits[0].surface).type == QuadricType::kCylinder);
  CHECK(std::abs(lean_of(fits[0].surface) - lean) < 0.02);
}

#include "bodies/expect_usual_walls.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/measure.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

constexpr double kCupCell = 0.004;
const Eigen::Vector3d kCupEye(1.0, 0.0, 0.0);

/// Moves samples of a wall that faces x to the far side of its axis, where they show its inside.
SurfaceSamples on_far_side(SurfaceSamples samples) {
  const Eigen::Vector3f mirror(-1.0f, 1.0f, 1.0f);
  for (int i = 0; i < samples.size(); ++i) {
    samples.p[i] = mirror.cwiseProduct(samples.p[i]);
    samples.raw[i] = mirror.cwiseProduct(samples.raw[i]);
    samples.n[i] = -mirror.cwiseProduct(samples.n[i]);
  }
  return samples;
}

/// Adds samples to others, and returns their numbers there.
std::vector<int> append(const SurfaceSamples& more, SurfaceSamples* all) {
  std::vector<int> numbers;
  const int before = all->size();
  for (int i = 0; i < more.size(); ++i) {
    numbers.push_back(before + i);
    all->p.push_back(more.p[i]);
    all->raw.push_back(more.raw[i]);
    all->n.push_back(more.n[i]);
    all->sigma.push_back(more.sigma[i]);
    all->cell.push_back(more.cell[i]);
    all->count.push_back(more.count[i]);
    all->source.push_back(before + i);
    for (const int j : more.neighbours_of(i)) all->neighbours.push_back(before + j);
    all->first.push_back(static_cast<int>(all->neighbours.size()));
  }
  return numbers;
}

/// A cup about z whose near outer and far inner side were seen, with the fits of both.
struct Cup {
  SurfaceSamples samples;
  std::vector<LastFit> fits;
  std::vector<Detection> detections;
  std::vector<CommonAxis> axes;
  std::vector<WallGap> gaps;

  /// @param outer, inner  radii of both sides [m]
  /// @param correlation   of the noise of neighbours, which tells that the sensor moves surfaces
  Cup(double outer, double inner, double noise, std::uint64_t seed, double correlation = 0.0) {
    samples.first.push_back(0);
    const std::vector<std::vector<int>> regions = {
        append(test::cylinder_grid(16, 10, outer, kCupCell, noise, 2 * seed), &samples),
        append(on_far_side(test::cylinder_grid(14, 8, inner, kCupCell, noise, 2 * seed + 1)),
               &samples)};
    AggregateOptions only_round;
    only_round.families = {Family::kCylinder};
    const std::vector<Eigen::Matrix3f> scatter(samples.p.size(), Eigen::Matrix3f::Zero());
    for (const std::vector<int>& region : regions) {
      const auto surface = fit_surface(samples, region, only_round);
      REQUIRE(surface);
      fits.push_back(last_fit(*surface, samples, scatter, {}));
      fits.back().surface.evidence.sigma = noise;
      fits.back().surface.evidence.correlation = correlation;
    }
    measure_all();
    axes = fit_common_axes(detections, &fits);
    measure_all();
  }

  void measure_all() {
    detections.clear();
    for (const LastFit& fit : fits) detections.push_back(measure(fit.surface, samples, kCupEye));
  }
  std::vector<int> expect_usual() {
    gaps = find_gaps(detections, fits, samples, axes);
    std::vector<int> changed = expect_usual_walls(samples, &gaps, &axes, &fits);
    measure_all();
    std::sort(changed.begin(), changed.end());
    return changed;
  }
  bool is_round() const {
    return std::all_of(fits.begin(), fits.end(), [](const LastFit& fit) {
      return fit.surface.fit.family == Family::kCylinder;
    });
  }
  const Dimension& radius(int side) const { return detections[side].dimensions[0]; }
};

TEST_CASE("the usual thickness of walls makes the radii of cups better, and their deviations true",
          "[bodies]") {
  constexpr int kCups = 60;
  constexpr double kRadius = 0.04;
  RandomStream random(5, 0);
  double before = 0.0, after = 0.0, std_before = 0.0, std_after = 0.0;
  int within = 0, within_gap = 0, seen = 0;
  for (std::uint64_t k = 0; k < kCups; ++k) {
    const double thickness = std::clamp(0.004 + 0.002 * test::gaussian(random), 0.001, 0.007);
    Cup cup(kRadius, kRadius - thickness, 0.002, k);
    if (cup.axes.size() != 1 || !cup.is_round()) continue;
    const std::vector<double> truth = {kRadius, kRadius - thickness};
    const std::vector<Dimension> alone = {cup.radius(0), cup.radius(1)};
    // Walls that seem to be thicker than 8 mm are left alone.
    if (cup.expect_usual().empty()) continue;
    for (int side = 0; side < 2; ++side) {
      before += std::pow(alone[side].value - truth[side], 2);
      std_before += alone[side].std;
    }
    REQUIRE(cup.gaps.size() == 1);
    CHECK(cup.gaps[0].std < 0.002);
    within_gap += std::abs(cup.gaps[0].thickness - thickness) < cup.gaps[0].std;
    CHECK(cup.radius(0).value - cup.radius(1).value == Approx(cup.gaps[0].thickness).margin(1e-4));
    for (int side = 0; side < 2; ++side) {
      const Dimension& radius = cup.radius(side);
      after += std::pow(radius.value - truth[side], 2);
      std_after += radius.std;
      within += std::abs(radius.value - truth[side]) < radius.std;
      ++seen;
    }
  }
  REQUIRE(seen > 1.5 * kCups);
  CAPTURE(std::sqrt(before / seen), std::sqrt(after / seen), std_before / seen, std_after / seen,
          double(within) / seen);
  CHECK(std::sqrt(after) < 0.8 * std::sqrt(before));
  CHECK(std_after < 0.9 * std_before);
  CHECK(within > 0.55 * seen);
  CHECK(within < 0.85 * seen);
  CHECK(within_gap > 0.5 * 0.5 * seen);
  CHECK(within_gap < 0.5 * 0.85 * seen);
}

TEST_CASE("the usual thickness makes up for what a sensor moves each side by", "[bodies]") {
  constexpr double kRadius = 0.04, kCorrelation = 0.5;
  // The standard deviation by which a sensor moves a surface, as in uncertainty.cpp [m].
  const double moves = 0.8 * std::sqrt(kCorrelation) * kCupCell;
  RandomStream random(6, 0);
  double before = 0.0, after = 0.0;
  int within = 0, within_gap = 0, seen = 0;
  for (std::uint64_t k = 0; k < 60; ++k) {
    const double thickness = std::clamp(0.004 + 0.002 * test::gaussian(random), 0.001, 0.007);
    const std::vector<double> truth = {kRadius, kRadius - thickness};
    const double outer = truth[0] + moves * test::gaussian(random);
    const double inner = truth[1] + moves * test::gaussian(random);
    Cup cup(outer, inner, 0.0005, k, kCorrelation);
    if (cup.axes.size() != 1 || !cup.is_round()) continue;
    const std::vector<double> alone = {cup.radius(0).value, cup.radius(1).value};
    if (cup.expect_usual().empty()) continue;
    REQUIRE(cup.gaps.size() == 1);
    CHECK(cup.gaps[0].std < 0.002);
    CHECK(cup.radius(0).value - cup.radius(1).value == Approx(cup.gaps[0].thickness).margin(1e-4));
    within_gap += std::abs(cup.gaps[0].thickness - thickness) < cup.gaps[0].std;
    for (int side = 0; side < 2; ++side) {
      before += std::pow(alone[side] - truth[side], 2);
      after += std::pow(cup.radius(side).value - truth[side], 2);
      within += std::abs(cup.radius(side).value - truth[side]) < cup.radius(side).std;
      ++seen;
    }
  }
  CAPTURE(std::sqrt(before / seen), std::sqrt(after / seen), within, within_gap, seen);
  REQUIRE(seen > 60);
  CHECK(std::sqrt(after) < 0.9 * std::sqrt(before));
  CHECK(within > 0.55 * seen);
  CHECK(within < 0.85 * seen);
  CHECK(within_gap > 0.5 * 0.55 * seen);
  CHECK(within_gap < 0.5 * 0.85 * seen);
}

TEST_CASE("a thickness that the samples show stays as it is", "[bodies]") {
  Cup cup(0.04, 0.033, 1e-4, 1);
  REQUIRE(cup.expect_usual() == std::vector{0, 1});
  CHECK(cup.radius(0).value == Approx(0.04).margin(3e-4));
  CHECK(cup.radius(1).value == Approx(0.033).margin(3e-4));
}

TEST_CASE("what is no wall of usual thickness is left alone", "[bodies]") {
  Cup cup(0.06, 0.048, 1e-4, 1);
  const Vector10d outer = cup.fits[0].surface.Q.coefficients();
  CHECK(cup.expect_usual().empty());
  CHECK(cup.fits[0].surface.Q.coefficients() == outer);
}

TEST_CASE("the covariance after the usual thickness is that of one more measurement", "[bodies]") {
  // With H the inverse of the covariance of all unknowns and g the derivative of the thickness by
  // them, it is (H + g gᵀ / σ²)⁻¹. First-order distances make half a per cent of difference.
  Cup cup(0.04, 0.035, 0.002, 3);
  REQUIRE(cup.axes.size() == 1);
  REQUIRE(cup.is_round());
  const CoaxialCovariance before = cup.axes[0].covariance;
  const Family family = Family::kCylinder;
  Eigen::VectorXd g = Eigen::VectorXd::Zero(before.unknowns.rows());
  for (std::size_t i = 0; i < cup.axes[0].members.size(); ++i) {
    const int side = cup.axes[0].members[i];
    const Surface& surface = cup.fits[side].surface;
    const auto radius_after = [&](Eigen::Index k, double step) {
      Eigen::VectorXd change = Eigen::VectorXd::Zero(before.map[i].rows());
      change[k] = step;
      const PosedQuadric posed = moved(family, surface.fit.posed, change);
      return surface.local.scale * canonical_form(posed).dimensions[0].second;
    };
    Eigen::VectorXd slope(before.map[i].rows());
    for (Eigen::Index k = 0; k < slope.size(); ++k) {
      slope[k] = (radius_after(k, 1e-5) - radius_after(k, -1e-5)) / 2e-5;
    }
    g += (side == 0 ? 1.0 : -1.0) * before.map[i].transpose() * slope;
  }
  cup.expect_usual();
  const Eigen::MatrixXd truth =
      (before.unknowns.inverse() + g * g.transpose() / (0.002 * 0.002)).inverse();
  CHECK((cup.axes[0].covariance.unknowns - truth).norm() < 5e-3 * truth.norm());
}

}  // namespace
}  // namespace quadrille

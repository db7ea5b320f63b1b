#include "samples/region.hpp"

#include <algorithm>
#include <cmath>

#include "samples/inliers.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/evidence/effective_share.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a quadric comes back from local coordinates, and holds the same points", "[region]") {
  Normalisation local;
  local.centre = {0.4, -1.2, 2.0};
  local.scale = 0.07;
  RandomStream random(71, 0);
  for (const FamilyExample& example : family_examples()) {
    const auto points = points_on(example.D, 10, example.low, random);
    const Quadric Q = local.to_frame(example.D);
    for (const OrientedPoint& p : points) {
      CHECK(std::abs(Q.distance(local.centre + local.scale * p.x)) < 1e-9);
    }
    CHECK((local.to_local(Q) - example.D).norm() < 1e-9);
  }
}

TEST_CASE("a region is normalised to mean zero and mean square radius one", "[region]") {
  const SurfaceSamples samples = sphere_grid(20, 20, 0.1, 0.005, 0.001, 1);
  const std::vector<int> region = all_of(samples);
  const OrientedPointsf points =
      fit_points(samples, region, normalisation_of(samples, region), 1000);
  REQUIRE(points.size() == 400);
  CHECK(std::abs(points.x().mean()) < 1e-5);
  CHECK(std::abs(points.z().mean()) < 1e-5);
  CHECK(points.points.colwise().squaredNorm().mean() == Approx(1.0));
  CHECK((points.at(3).n - samples.n[3].cast<double>()).norm() < 1e-6);
}

TEST_CASE("a fit takes no more points than asked for, spread over the region", "[region]") {
  const SurfaceSamples samples = plane_grid(20, 20, 0.005, 0.0, 1);
  const std::vector<int> region = all_of(samples);
  const Normalisation local = normalisation_of(samples, region);
  const OrientedPointsf few = fit_points(samples, region, local, 50);
  REQUIRE(few.size() == 50);
  CHECK(few.z().minCoeff() < -1.1f);
  CHECK(few.z().maxCoeff() > 1.0f);
}

TEST_CASE("an inlier lies within its noise and has the normal of the quadric, up to sign",
          "[region]") {
  SurfaceSamples samples = plane_grid(2, 1, 0.004, 0.0, 1);
  samples.sigma[0] = 0.001f;
  Eigen::Matrix4f Q = Eigen::Matrix4f::Zero();
  Q(0, 3) = Q(3, 0) = 3.0f;
  InlierTest test;
  test.sigmas = 3.0, test.cells = 0.1, test.min_cosine = 0.9;
  const auto at = [&](float x, float angle) {
    samples.raw[0].x() = x;
    samples.n[0] = {std::cos(angle), std::sin(angle), 0.0f};
    return is_inlier(samples, 0, Q, test);
  };
  // 3 sigma and a tenth of a cell are 3.4 mm; cos 0.451 = 0.9.
  CHECK(at(0.0033f, 0.0f));
  CHECK(at(-0.0033f, 0.0f));
  CHECK_FALSE(at(0.0035f, 0.0f));
  CHECK(at(0.0f, 0.44f));
  CHECK_FALSE(at(0.0f, 0.46f));
  CHECK(at(0.0f, static_cast<float>(M_PI)));
  test.min_cosine = -1.0;
  CHECK(at(0.0f, 1.5f));
}

TEST_CASE("a region grows over connected inliers only and only over free ones", "[region]") {
  const SurfaceSamples samples = plane_grid(30, 10, 0.004, 0.0, 1);
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  D(0, 3) = D(3, 0) = 0.5;
  Mask free(static_cast<std::size_t>(samples.size()), 1);
  Marks seen(static_cast<std::size_t>(samples.size()));
  const std::vector<int> start = {0};
  CHECK(connected_inliers(samples, start, Quadric(D), {}, free, &seen).size() == 300);
  for (int j = 0; j < 10; ++j) free[static_cast<std::size_t>(j * 30 + 12)] = 0;
  const std::vector<int> left = connected_inliers(samples, start, Quadric(D), {}, free, &seen);
  CHECK(left.size() == 120);
  CHECK(std::all_of(left.begin(), left.end(), [](int i) { return i % 30 < 12; }));
  // A start beyond the plane's own points is not taken over.
  D(3, 3) = 1.0;
  CHECK(connected_inliers(samples, start, Quadric(D), {}, free, &seen).empty());
}

TEST_CASE("white noise leaves each sample its vote, waves do not", "[region]") {
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  D(0, 3) = D(3, 0) = 0.5;
  SurfaceSamples samples = plane_grid(60, 60, 0.004, 0.001, 2);
  const std::vector<int> region = all_of(samples);
  CHECK(effective_share(samples, region, Quadric(D)) > 0.9);
  // A wave of period P has correlation cos(2π/P) with the next sample along it, 1 across.
  constexpr double kPeriod = 12;
  for (int i = 0; i < samples.size(); ++i) {
    samples.raw[i].x() = static_cast<float>(0.001 * std::sin(2 * M_PI * (i % 60) / kPeriod));
  }
  const double rho = (6 * std::cos(2 * M_PI / kPeriod) + 2) / 8;
  const double root = std::sqrt(effective_share(samples, region, Quadric(D)));
  CHECK((1 - root) / (1 + root) == Approx(rho).margin(0.02));
  CHECK(effective_share(samples, std::vector<int>{5}, Quadric(D)) == 1.0);
}

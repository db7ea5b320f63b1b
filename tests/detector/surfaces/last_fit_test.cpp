#include "surfaces/last_fit.hpp"

#include <cmath>

#include "detector/table_scene.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/surface_fit.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Samples that are means of points on a sphere or cylinder around z, and the covariance of those
/// points.
struct Averaged {
  SurfaceSamples samples;
  std::vector<Eigen::Matrix3f> scatter;
};

Averaged averaged(bool round, double radius, double cell) {
  constexpr int kColumns = 15, kRows = 15, kSide = 5;
  const auto point = [&](double x, double y) -> Eigen::Vector3d {
    const double a = x / radius, b = y / radius;
    if (!round) return {radius * std::cos(a), radius * std::sin(a), y};
    return radius *
           Eigen::Vector3d(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
  };
  Averaged result;
  result.samples = round ? sphere_grid(kColumns, kRows, radius, cell, 0.0, 1)
                         : cylinder_grid(kColumns, kRows, radius, cell, 0.0, 1);
  for (int k = 0; k < kColumns * kRows; ++k) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    for (int s = 0; s < kSide * kSide; ++s) {
      const auto along = [&](int sample, int part, int count) {
        return cell * (sample - 0.5 * (count - 1) + (part - 0.5 * (kSide - 1)) / kSide);
      };
      const Eigen::Vector3d x =
          point(along(k % kColumns, s % kSide, kColumns), along(k / kColumns, s / kSide, kRows));
      mean += x / (kSide * kSide);
      square += x * x.transpose() / (kSide * kSide);
    }
    result.samples.raw[k] = mean.cast<float>();
    result.scatter.push_back((square - mean * mean.transpose()).cast<float>());
  }
  return result;
}

double radius_of(const Surface& surface) {
  return surface.local.scale * canonical_form(surface.fit.posed).dimensions.front().second;
}

}  // namespace

TEST_CASE("the last fit gives the radius that averaging over cells has made smaller", "[fit]") {
  constexpr double kRadius = 0.05;
  for (const bool round : {true, false}) {
    for (const double cell : {0.002, 0.004, 0.006}) {
      const Averaged averages = averaged(round, kRadius, cell);
      const auto fit = fit_surface(averages.samples, all_of(averages.samples), {});
      REQUIRE(fit);
      REQUIRE(fit->fit.family == (round ? Family::kSphere : Family::kCylinder));
      const Surface last = last_fit(*fit, averages.samples, averages.scatter, {}).surface;
      // The mean lies half the curvature times the variance along each curved direction inside.
      const double inside = (round ? 2.0 : 1.0) * cell * cell / 12.0 / (2.0 * kRadius);
      CAPTURE(round, cell, inside, radius_of(*fit), radius_of(last));
      CHECK(radius_of(*fit) < kRadius - 0.4 * inside);
      CHECK(std::abs(radius_of(last) - kRadius) < 0.1 * inside);
      CHECK(last.region == fit->region);
    }
  }
}

TEST_CASE("the radii of exact balls and cans do not depend on the cells", "[detector]") {
  Camera camera;
  camera.width = 640, camera.height = 480, camera.pitch = 1.0 / 600.0;
  const PointCloud cloud = render(TableScene().patches(), camera);
  for (const double cell : {0.002, 0.004, 0.006}) {
    DetectorOptions options;
    options.sampling.cell = cell;
    const DetectionResult result = detect(cloud, options);
    const Detection* const ball = find(result, QuadricType::kSphere);
    const Detection* const can = find(result, QuadricType::kCylinder);
    REQUIRE(ball);
    REQUIRE(can);
    CAPTURE(cell, dimension(*ball, "radius"), dimension(*can, "radius"));
    CHECK(dimension(*ball, "radius") == Approx(kBall).margin(0.00015));
    CHECK(dimension(*can, "radius") == Approx(kCan).margin(0.00015));
  }
}

TEST_CASE("a plane has no last fit", "[fit]") {
  const SurfaceSamples samples = plane_grid(20, 20, 0.005, 0.0002, 1);
  const auto plane = fit_plane(samples, all_of(samples), {});
  REQUIRE(plane);
  const Surface last = last_fit(*plane, samples, {}, {}).surface;
  CHECK(last.Q.coefficients() == plane->Q.coefficients());
}

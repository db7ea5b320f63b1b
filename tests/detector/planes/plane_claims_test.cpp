#include "planes/plane_claims.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/aggregate.hpp"
#include "surfaces/plane_surface.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

PlaneRegion region_of(const SurfaceSamples& samples, const Eigen::Vector4d& plane) {
  return {plane, all_of(samples)};
}

}  // namespace

TEST_CASE("the cells of a table are claimed, those of what stands on it are not",
          "[planes][claims]") {
  Camera camera;
  camera.noise = 0.001;
  const auto pyramid = make_depth_pyramid(
      render({rectangle(translation(0, 0, 1.0), 1e3, 1e3), sphere(translation(0, 0, 1.0), 0.08)},
             camera),
      {});
  const SurfaceSamples coarse = pyramid->coarse_samples();
  const auto planes = find_planes(coarse, {});
  REQUIRE(planes.size() == 1);
  const Mask keep = cells_off_planes(planes_of_cells(*pyramid, coarse, planes, 3.0));
  REQUIRE(keep.size() == static_cast<std::size_t>(pyramid->size(0)));
  int table = 0, claimed = 0, ball = 0, kept = 0;
  for (int c = 0; c < pyramid->size(0); ++c) {
    const Eigen::Vector3f x = pyramid->mean(c);
    if (x.z() < 0.985f) {
      ++ball;
      kept += keep[static_cast<std::size_t>(c)];
    } else if (x.head<2>().norm() > 0.12f) {
      ++table;
      claimed += !keep[static_cast<std::size_t>(c)];
    }
  }
  REQUIRE(table > 10000);
  REQUIRE(ball > 1000);
  CHECK(claimed > 0.98 * table);
  CHECK(kept == ball);
}

TEST_CASE("a plane's region is fitted as a surface with the noise as rms", "[planes][claims]") {
  const SurfaceSamples samples = plane_grid(40, 40, 0.01, 0.001, 1);
  const Surface surface = plane_surface(samples, region_of(samples, {1, 0, 0, 0}));
  CHECK(surface.fit.family == Family::kPlane);
  CHECK(surface.rms == Approx(0.001).epsilon(0.1));
  CHECK(surface.region.size() == 1600);
  CHECK(surface.Q.coefficients().norm() == Approx(1.0));
  const Eigen::Vector3d n = surface.Q.gradient(Eigen::Vector3d::Zero()).normalized();
  CHECK(std::abs(n.x()) > 0.99999);
  CHECK(std::abs(surface.Q.distance(Eigen::Vector3d::Zero())) < 2e-4);
}

TEST_CASE("samples that determine no plane lie on the one that is given", "[planes][claims]") {
  const SurfaceSamples samples = plane_grid(40, 40, 0.01, 0.0, 1);
  // The plane 2 cm from the samples, which all lie in x = 0.
  const Eigen::Vector4d given(1.0, 0.0, 0.0, -0.02);
  for (const std::vector<int>& few : {std::vector<int>{7}, {7, 8}, {7, 8, 9, 10, 11, 12}}) {
    const Surface surface = plane_surface(samples, {given, few});
    REQUIRE(surface.Q.coefficients().allFinite());
    if (few.size() > 2) continue;
    const Eigen::Vector3d p = samples.raw[7].cast<double>();
    CHECK(std::abs(surface.Q.distance(p)) == Approx(0.02));
    CHECK(std::abs(surface.Q.gradient(p).normalized().x()) == Approx(1.0));
  }
  // Too few are no surface.
  Aggregation aggregation(samples, {}, {});
  aggregation.offer_planes({{given, {7, 8}}});
  CHECK(aggregation.surfaces().empty());
}

TEST_CASE("a flat piece near a plane and parallel to it is part of it, another is not",
          "[planes][claims]") {
  const SurfaceSamples samples = plane_grid(20, 20, 0.01, 0.001, 2);
  const Surface flat = plane_surface(samples, region_of(samples, {1, 0, 0, 0}));
  const auto part_of = [&](double angle, double offset) {
    const PlaneRegion plane{{std::cos(angle), std::sin(angle), 0.0, offset}, {}};
    return is_part_of(flat, samples, {plane}, samples);
  };
  CHECK(part_of(0.0, 0.0));
  CHECK(part_of(0.0, 0.003));
  CHECK(part_of(M_PI, 0.003));
  CHECK_FALSE(part_of(0.0, 0.02));
  CHECK_FALSE(part_of(0.5, 0.0));
}

TEST_CASE("a piece that waves have moved off a table is still part of it, nearby it is not",
          "[planes][claims]") {
  // Two pieces of one grid, 20 cells wide each, the second lifted by 8 mm.
  SurfaceSamples samples = plane_grid(120, 20, 0.01, 0.0003, 3);
  PlaneRegion table{{1, 0, 0, 0}, {}};
  std::vector<int> far, near;
  for (int i = 0; i < samples.size(); ++i) {
    const int column = i % 120;
    if (column < 20) table.samples.push_back(i);
    if (column >= 20 && column < 40) near.push_back(i);
    if (column >= 100) far.push_back(i);
  }
  for (auto* x : {&samples.raw, &samples.p}) {
    for (const int i : near) (*x)[i].x() += 0.008f;
    for (const int i : far) (*x)[i].x() += 0.008f;
  }
  const auto part_of = [&](const std::vector<int>& piece) {
    const PlaneRegion lifted{{1, 0, 0, -0.008}, piece};
    return is_part_of(plane_surface(samples, lifted), samples, {table}, samples);
  };
  CHECK(part_of(far));
  CHECK_FALSE(part_of(near));
}

TEST_CASE("planes are weighed as surfaces", "[planes][claims]") {
  const SurfaceSamples samples = plane_grid(40, 40, 0.01, 0.001, 1);
  const auto surfaces = weighed_planes(samples, {region_of(samples, {1, 0, 0, 0})}, {});
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].confidence > 0.5);
  CHECK(surfaces[0].evidence.log_count == Approx(std::log(1600.0)));
}

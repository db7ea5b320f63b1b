#include "surfaces/measure.hpp"

#include <cmath>

#include "planes/plane_claims.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/aggregate.hpp"
#include "surfaces/plane_surface.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// The surface of a candidate that holds all samples, as the aggregation makes it.
std::optional<Surface> surface_of(const SurfaceSamples& samples, const Quadric& Q, Family family) {
  Aggregation aggregation(samples, {}, {});
  Candidate candidate;
  candidate.Q = Q;
  candidate.family = family;
  candidate.region = all_of(samples);
  aggregation.offer({candidate}, SearchLevel::kFinest);
  if (aggregation.surfaces().size() != 1) return std::nullopt;
  return aggregation.surfaces()[0];
}

const Dimension& published(const Detection& detection, const std::string& name) {
  for (const Dimension& d : detection.dimensions) {
    if (d.name == name) return d;
  }
  throw std::logic_error("no dimension " + name);
}

const Eigen::Vector3d kEye(1, 0.2, 0.1);

}  // namespace

TEST_CASE("a cylinder gets its radius, length, axis, extent and seen share", "[measure]") {
  constexpr double kRadius = 0.05, kCell = 0.004, kNoise = 0.0003;
  // 31 columns of 4 mm: 120 mm of an arc of radius 50 mm, 2.4 rad; 41 rows: 160 mm.
  const SurfaceSamples samples = cylinder_grid(31, 41, kRadius, kCell, kNoise, 1);
  const auto surface =
      surface_of(samples, Quadric(diagonal(1, 1, 0, -kRadius * kRadius)), Family::kCylinder);
  REQUIRE(surface);
  const Detection d = measure(*surface, samples, kEye);
  CHECK(d.type == QuadricType::kCylinder);
  CHECK(published(d, "radius").value == Approx(kRadius).epsilon(0.01));
  CHECK(published(d, "length").value == Approx(0.16).margin(2 * kCell));
  CHECK(d.inliers == static_cast<int>(surface->region.size()));
  CHECK(d.X_CQ.translation().norm() < 0.002);
  CHECK(std::abs(d.X_CQ.linear()(2, 2)) > 0.9995);
  CHECK(d.X_CQ.linear().determinant() == Approx(1.0));
  // Half a cell and two deviations of the noise are lost at either end.
  CHECK(d.extent_Q.sizes().z() ==
        Approx(published(d, "length").value - kCell - 4 * kNoise).margin(1e-6));
  CHECK(d.extent_Q.center().z() == Approx(0.0).margin(0.003));
  CHECK(d.seen == Approx(2.4 / (2 * M_PI)).margin(0.05));
  CHECK(d.Q_C.coefficients().norm() == Approx(1.0));
  // The gradient points to the side that was seen: outwards.
  CHECK(d.Q_C.gradient({1.1 * kRadius, 0, 0}).x() > 0);
}

TEST_CASE("normals that look inwards turn the gradient inwards", "[measure]") {
  SurfaceSamples samples = sphere_grid(30, 30, 0.06, 0.004, 0.0003, 2);
  for (Eigen::Vector3f& n : samples.n) n = -n;
  const auto surface = surface_of(samples, Quadric(diagonal(1, 1, 1, -0.0036)), Family::kSphere);
  REQUIRE(surface);
  const Detection d = measure(*surface, samples, Eigen::Vector3d::Zero());
  CHECK(d.type == QuadricType::kSphere);
  CHECK(d.Q_C.gradient({0.06, 0, 0}).x() < 0);
  CHECK(d.X_CQ.translation().norm() < 0.002);
}

TEST_CASE("a can in a cloud joined from views all round shows its outside", "[measure]") {
  constexpr double kRadius = 0.05;
  // 79 columns of 4 mm go once round.
  SurfaceSamples samples = cylinder_grid(79, 41, kRadius, 0.004, 0.0003, 3);
  const Quadric can(diagonal(1, 1, 0, -kRadius * kRadius));
  const auto inside_seen = [&] {
    const auto surface = surface_of(samples, can, Family::kCylinder);
    REQUIRE(surface);
    const Detection d = measure(*surface, samples, kEye);
    CHECK(d.seen > 0.9);
    return shows_inside(d);
  };
  // Normals towards the eye: a little more than half of them look into the can.
  int inwards = 0;
  for (int i = 0; i < samples.size(); ++i) {
    if (samples.n[i].dot(kEye.cast<float>() - samples.raw[i]) > 0.0f) continue;
    samples.n[i] = -samples.n[i];
    ++inwards;
  }
  CHECK(2 * inwards > samples.size());
  CHECK_FALSE(inside_seen());
  // All normals of a bowl that is seen from above look into it.
  for (int i = 0; i < samples.size(); ++i) {
    if (samples.n[i].dot(samples.raw[i]) > 0.0f) samples.n[i] = -samples.n[i];
  }
  CHECK(inside_seen());
}

TEST_CASE("a plane has its normal towards the viewpoint, and width and height", "[measure]") {
  for (const double side : {1.0, -1.0}) {
    const SurfaceSamples samples = plane_grid(61, 31, 0.01, 0.0005, 3);
    const Surface surface = plane_surface(samples, {{side, 0, 0, 0}, all_of(samples)});
    const Detection d = measure(surface, samples, {side, 0.1, 0.0});
    CHECK(d.type == QuadricType::kPlane);
    CHECK(d.X_CQ.linear().col(2).x() * side > 0.999);
    CHECK(published(d, "width").value == Approx(0.6).margin(0.03));
    CHECK(published(d, "height").value == Approx(0.3).margin(0.03));
    CHECK(d.X_CQ.translation().norm() < 0.01);
    CHECK(d.seen > 0.95);
  }
}

TEST_CASE("the length of a cylinder with a ragged end has a larger deviation", "[measure]") {
  constexpr double kRadius = 0.05, kCell = 0.004, kStray = 0.05;
  SurfaceSamples samples = cylinder_grid(31, 41, kRadius, kCell, 0.0003, 1);
  const auto surface =
      surface_of(samples, Quadric(diagonal(1, 1, 0, -kRadius * kRadius)), Family::kCylinder);
  REQUIRE(surface);
  const double sharp = published(measure(*surface, samples, kEye), "length").std;
  CHECK(sharp < kCell);
  // One sample in a hundred lies beyond the end, as where a table meets the cylinder.
  for (int i = samples.size() - 13; i < samples.size(); ++i) {
    samples.raw[i] += static_cast<float>(kStray) * Eigen::Vector3f::UnitZ();
  }
  const Dimension ragged = published(measure(*surface, samples, kEye), "length");
  CHECK(std::abs(ragged.value - 0.16) < 2.0 * ragged.std);
}

TEST_CASE("standard deviations are honest: the true radius lies within three of them",
          "[measure][law]") {
  constexpr double kRadius = 0.04, kNoise = 0.001;
  for (const bool round : {true, false}) {
    int found = 0, within = 0;
    double deviation = 0, square = 0;
    for (std::uint64_t k = 0; k < 100; ++k) {
      const SurfaceSamples samples = round ? sphere_grid(20, 20, kRadius, 0.004, kNoise, 1000 + k)
                                           : cylinder_grid(20, 30, kRadius, 0.004, kNoise, k);
      const auto surface = surface_of(samples, Quadric(diagonal(1, 1, round, -kRadius * kRadius)),
                                      round ? Family::kSphere : Family::kCylinder);
      if (!surface) continue;
      const Detection d = measure(*surface, samples, kEye);
      if (d.type != (round ? QuadricType::kSphere : QuadricType::kCylinder)) continue;
      ++found;
      const Dimension radius = published(d, "radius");
      CHECK(radius.std > 0.0);
      within += std::abs(radius.value - kRadius) <= 3.0 * radius.std;
      deviation += radius.std;
      square += std::pow(radius.value - kRadius, 2);
    }
    CAPTURE(round, found, within);
    REQUIRE(found >= 95);
    CHECK(within >= 0.95 * found);
    // Nor are they so large that they say nothing: a tenth of the radius is 4 mm.
    CHECK(deviation / found < 0.1 * kRadius);
    CHECK(std::sqrt(square / found) < 0.02 * kRadius);
  }
}

#include "bodies/one_centre.hpp"

#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/measure.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

constexpr double kOuterRadius = 0.06, kInnerRadius = 0.055;
constexpr double kBowlCell = 0.004, kBowlNoise = 0.0005;
const Eigen::Vector3d kBowlEye(1.0, 0.0, 0.0);

/// A piece of a sphere about the origin, with its last fit and as it is measured.
struct SpherePiece {
  LastFit fit;
  Detection detection;
};

SpherePiece piece_of(const SurfaceSamples& samples) {
  AggregateOptions only_spheres;
  only_spheres.families = {Family::kSphere};
  const auto surface = fit_surface(samples, test::all_of(samples), only_spheres);
  REQUIRE(surface);
  const std::vector<Eigen::Matrix3f> scatter(samples.p.size(), Eigen::Matrix3f::Zero());
  SpherePiece piece;
  piece.fit = last_fit(*surface, samples, scatter, {});
  piece.fit.surface.evidence.sigma = kBowlNoise;
  piece.detection = measure(piece.fit.surface, samples, kBowlEye);
  return piece;
}

/// The outside of a bowl, which faces the eye.
SpherePiece outside(int cells, std::uint64_t seed) {
  return piece_of(test::sphere_grid(cells, cells, kOuterRadius, kBowlCell, kBowlNoise, seed));
}

/// The inside of a bowl, on the far side of its centre.
SpherePiece inside(int cells, std::uint64_t seed) {
  SurfaceSamples samples =
      test::sphere_grid(cells, cells, kInnerRadius, kBowlCell, kBowlNoise, seed);
  // Points are mirrored at the centre, and normals still look at the eye.
  for (Eigen::Vector3f& p : samples.p) p = -p;
  for (Eigen::Vector3f& p : samples.raw) p = -p;
  return piece_of(samples);
}

std::vector<std::vector<int>> walls_among(const std::vector<SpherePiece>& pieces) {
  std::vector<Detection> detections;
  std::vector<LastFit> fits;
  for (const SpherePiece& piece : pieces) {
    detections.push_back(piece.detection);
    fits.push_back(piece.fit);
  }
  std::vector<std::vector<int>> walls;
  for (const CentredWall& wall : find_centred_walls(detections, fits)) {
    walls.emplace_back();
    for (const Member& side : wall.sides) walls.back().push_back(side.index);
  }
  return walls;
}

TEST_CASE("the two sides of a bowl are spheres about one centre", "[bodies]") {
  const SpherePiece outer = outside(20, 1), inner = inside(20, 2);
  const std::vector<Detection> detections = {outer.detection, inner.detection};
  const std::vector<LastFit> fits = {outer.fit, inner.fit};
  const std::vector<CentredWall> walls = find_centred_walls(detections, fits);
  REQUIRE(walls.size() == 1);
  const auto centre_of = [&](std::size_t side) -> Eigen::Vector3d {
    const CoaxialPart& part = walls[0].sides[side].part;
    return part.local.centre + part.local.scale * walls[0].fit.parts[side].posed.X.translation();
  };
  CHECK((centre_of(0) - centre_of(1)).norm() < 1e-9);
  CHECK(centre_of(0).norm() < 0.001);
}

TEST_CASE("of two insides of one outside the one that shows more is its other side", "[bodies]") {
  const SpherePiece outer = outside(20, 1), small = inside(10, 2), large = inside(20, 3);
  CHECK(walls_among({outer, small, large}) == std::vector<std::vector<int>>{{0, 2}});
  CHECK(walls_among({outer, large, small}) == std::vector<std::vector<int>>{{0, 1}});
  CHECK(walls_among({small, large, outer}) == std::vector<std::vector<int>>{{2, 1}});
}

TEST_CASE("two outsides are no wall", "[bodies]") {
  CHECK(walls_among({outside(20, 1), outside(20, 2)}).empty());
}

}  // namespace
}  // namespace quadrille

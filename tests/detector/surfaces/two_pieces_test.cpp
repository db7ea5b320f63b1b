#include "surfaces/two_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/sibling.hpp"
#include "surfaces/surface_fit.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kBottleCell = 0.003, kBottleNoise = 0.0003;
constexpr double kBodyRadius = 0.035, kNeckRadius = 0.015, kShoulderSlope = -0.5;
// Heights at which the shoulder begins and ends.
constexpr double kShoulder = 0.06, kTop = kShoulder + (kNeckRadius - kBodyRadius) / kShoulderSlope;
constexpr int kBottleColumns = 19;

/// A point of a profile: radius at a height, and slope there.
struct ProfilePlace {
  double r, slope;
};

/// The half of a body of revolution that a camera on the x axis sees, from height `low` on.
template <typename Profile>
SurfaceSamples seen_half(const Profile& profile, double low, int rows, double noise,
                         std::uint64_t seed) {
  return surface_grid(
      kBottleColumns, rows,
      [&](int i, int j) {
        const double z = low + kBottleCell * j, angle = 2.6 * (i / (kBottleColumns - 1.0) - 0.5);
        const auto [r, slope] = profile(z);
        const Eigen::Vector3d n(std::cos(angle), std::sin(angle), -slope);
        return OrientedPoint{Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z),
                             n.normalized()};
      },
      kBottleCell, noise, seed);
}

/// @param rounding  the crease above the shoulder is a parabola from so far below it to as far
/// above
ProfilePlace bottle(double z, double rounding) {
  if (z < kShoulder) return {kBodyRadius, 0.0};
  const double over = z - kTop;
  if (over < -rounding) return {kNeckRadius + kShoulderSlope * over, kShoulderSlope};
  if (over > rounding) return {kNeckRadius, 0.0};
  const double left = (over - rounding) / (2.0 * rounding);
  return {kNeckRadius - kShoulderSlope * rounding * left * left, -kShoulderSlope * left};
}

SurfaceSamples bottle_samples(double rounding, std::uint64_t seed) {
  return seen_half([&](double z) { return bottle(z, rounding); }, 0.0, 44, kBottleNoise, seed);
}

/// The surface of the samples between two heights.
Surface surface_between(const SurfaceSamples& samples, double low, double high) {
  std::vector<int> region;
  for (int i = 0; i < samples.size(); ++i) {
    if (samples.raw[i].z() >= low && samples.raw[i].z() < high) region.push_back(i);
  }
  const auto surface = fit_surface(samples, std::move(region), {});
  REQUIRE(surface);
  return *surface;
}

/// Marks the samples from a height on as free.
Mask free_above(const SurfaceSamples& samples, double height) {
  Mask free(static_cast<std::size_t>(samples.size()), 0);
  for (int i = 0; i < samples.size(); ++i) free[i] = samples.raw[i].z() > height;
  return free;
}

double cylinder_radius(const Surface& cylinder) {
  return cylinder.local.scale * form_of(cylinder).dimensions.front().second;
}

double cone_angle(const Surface& cone) { return form_of(cone).dimensions.front().second; }

}  // namespace

TEST_CASE("the neck and the shoulder of a bottle pass for a hyperboloid, and are told apart",
          "[pieces]") {
  // Sensors round the crease.
  const double rounding = GENERATE(0.001, 0.006);
  const SurfaceSamples samples = bottle_samples(rounding, GENERATE(1, 2, 3));
  const Surface body = surface_between(samples, 0.0, kShoulder);
  const Surface both = surface_between(samples, kShoulder + 0.001, 1.0);
  REQUIRE(form_of(both).type == QuadricType::kHyperboloidOneSheet);
  const std::vector<Surface> surfaces = {both, body};
  const Surface* sibling = sibling_of(surfaces[0], surfaces, samples);
  REQUIRE(sibling == &surfaces[1]);
  const auto pieces = two_pieces(both, sibling, samples, free_above(samples, kShoulder), {});
  REQUIRE(pieces);
  CHECK(pieces->gain > 0.0);
  CHECK(std::abs(cylinder_radius(pieces->cylinder) - kNeckRadius) < 0.0005);
  CHECK(std::abs(cone_angle(pieces->cone) - std::atan(-kShoulderSlope)) < 0.03);
  for (const int i : pieces->cone.region) CHECK(samples.raw[i].z() < kTop + 2.0 * kBottleCell);
  for (const int i : pieces->cylinder.region) CHECK(samples.raw[i].z() > kTop - 2.0 * kBottleCell);
}

TEST_CASE("the body and the shoulder of a bottle are told apart without a sibling", "[pieces]") {
  const SurfaceSamples samples = bottle_samples(0.001, GENERATE(1, 2, 3));
  const Surface both = surface_between(samples, 0.0, kTop);
  REQUIRE(both.fit.family == Family::kRevolution);
  const auto pieces = two_pieces(both, nullptr, samples, {}, {});
  REQUIRE(pieces);
  CHECK(std::abs(cylinder_radius(pieces->cylinder) - kBodyRadius) < 0.0005);
  CHECK(std::abs(cone_angle(pieces->cone) - std::atan(-kShoulderSlope)) < 0.05);
}

TEST_CASE("a vase is one hyperboloid, and an egg one ellipsoid", "[pieces]") {
  const auto vase = [](double z) {
    const double r = std::sqrt(0.02 * 0.02 + 0.15 * z * z);
    return ProfilePlace{r, 0.15 * z / r};
  };
  const auto egg = [](double z) {
    const double r = std::sqrt(0.03 * 0.03 - 0.4 * z * z);
    return ProfilePlace{r, -0.4 * z / r};
  };
  const int seed = GENERATE(1, 2, 3);
  const SurfaceSamples of_vase = seen_half(vase, -0.06, 41, kBottleNoise, seed);
  const SurfaceSamples of_egg = seen_half(egg, -0.04, 27, kBottleNoise, seed);
  CHECK_FALSE(two_pieces(surface_between(of_vase, -1.0, 1.0), nullptr, of_vase, {}, {}));
  CHECK_FALSE(two_pieces(surface_between(of_egg, -1.0, 1.0), nullptr, of_egg, {}, {}));
}

TEST_CASE("noise and what stands beside them do not divide a vase and a goblet", "[pieces]") {
  const auto vase = [](double z) {
    const double r = std::sqrt(0.02 * 0.02 + 0.15 * z * z);
    return ProfilePlace{r, 0.15 * z / r};
  };
  // An ellipsoid of 35 mm on a stem of 10 mm.
  const auto goblet = [](double z) {
    const double square = 0.035 * 0.035 - 0.9 * z * z;
    if (square < 0.01 * 0.01) return ProfilePlace{0.01, 0.0};
    return ProfilePlace{std::sqrt(square), -0.9 * z / std::sqrt(square)};
  };
  int vases = 0, goblets = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SurfaceSamples of_vase = seen_half(vase, -0.04, 34, 0.001, seed);
    vases += two_pieces(surface_between(of_vase, -1.0, 1.0), nullptr, of_vase, {}, {}).has_value();
    const SurfaceSamples of_goblet = seen_half(goblet, -0.07, 32, 0.001, seed);
    const Surface bowl = surface_between(of_goblet, -0.034, 1.0);
    goblets += two_pieces(bowl, nullptr, of_goblet, {}, {}).has_value();
  }
  CAPTURE(vases, goblets);
  CHECK(vases <= 2);
  CHECK(goblets <= 2);
}

TEST_CASE("an inner side stays whole", "[pieces]") {
  SurfaceSamples samples = bottle_samples(0.001, 1);
  const Surface outer = surface_between(samples, 0.0, kTop);
  REQUIRE(two_pieces(outer, nullptr, samples, {}, {}));
  for (Eigen::Vector3f& n : samples.n) n = -n;
  CHECK_FALSE(two_pieces(outer, nullptr, samples, {}, {}));
}

TEST_CASE("samples of other surfaces belong to neither piece", "[pieces]") {
  const SurfaceSamples samples = bottle_samples(0.001, 1);
  const Surface both = surface_between(samples, kShoulder + 0.001, kTop + 0.02);
  const Surface body = surface_between(samples, 0.0, kShoulder);
  const auto pieces = two_pieces(both, &body, samples, free_above(samples, 1.0), {});
  REQUIRE(pieces);
  for (const Surface* piece : {&pieces->cylinder, &pieces->cone}) {
    for (const int i : piece->region) {
      CHECK(std::find(both.region.begin(), both.region.end(), i) != both.region.end());
    }
  }
  // The neck goes on over free samples.
  const auto longer = two_pieces(both, &body, samples, free_above(samples, kShoulder), {});
  REQUIRE(longer);
  CHECK(longer->cylinder.region.size() > pieces->cylinder.region.size());
}

TEST_CASE("the other side of a wall is no sibling", "[pieces]") {
  const SurfaceSamples samples = bottle_samples(0.001, 1);
  const Surface both = surface_between(samples, kShoulder + 0.001, 1.0);
  Surface around = surface_between(samples, 0.0, kShoulder);
  REQUIRE(sibling_of(both, std::vector{around}, samples));
  around.region = both.region;
  around.local.centre.z() = both.local.centre.z();
  CHECK(sibling_of(both, std::vector{around}, samples) == nullptr);
}

TEST_CASE("a cylinder elsewhere is no sibling", "[pieces]") {
  const SurfaceSamples samples = bottle_samples(0.001, 1);
  const Surface both = surface_between(samples, kShoulder + 0.001, 1.0);
  Surface body = surface_between(samples, 0.0, kShoulder);
  body.fit.posed.X.translation().x() += 0.5;
  CHECK(sibling_of(both, std::vector{body}, samples) == nullptr);
  CHECK(sibling_of(body, std::vector{both}, samples) == nullptr);
}

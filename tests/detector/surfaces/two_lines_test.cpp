#include "surfaces/two_lines.hpp"

#include <cmath>
#include <random>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// The profile of a bottle: a neck of radius 15 mm down to 60 mm, and a shoulder that widens by
/// half of its height.
std::vector<MeridianPoint> neck_and_shoulder(float noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  std::vector<MeridianPoint> points;
  for (float z = 0.02f; z < 0.09f; z += 0.0004f) {
    const float r = z < 0.06f ? 0.035f - 0.5f * (z - 0.02f) : 0.015f;
    points.push_back({z, r + noise * normal(random), 1e-7f});
  }
  return points;
}

}  // namespace

TEST_CASE("two lines are those of the neck and the shoulder", "[pieces]") {
  const TwoLines exact = two_lines(neck_and_shoulder(0.0f, 1));
  CHECK(std::abs(exact.radius - 0.015f) < 1e-6f);
  CHECK(std::abs(exact.slope + 0.5f) < 1e-4f);
  CHECK(std::abs(exact.r0 - 0.045f) < 1e-5f);
  CHECK(exact.loss < 0.01f);
  const TwoLines noisy = two_lines(neck_and_shoulder(0.0003f, GENERATE(1u, 2u, 3u)));
  CHECK(std::abs(noisy.radius - 0.015f) < 0.0005f);
  CHECK(std::abs(noisy.slope + 0.5f) < 0.08f);
}

TEST_CASE("two lines do not follow what lies on something else", "[pieces]") {
  std::vector<MeridianPoint> points = neck_and_shoulder(0.0f, 1);
  for (std::size_t k = 0; k < points.size(); k += 4) points[k].r += 0.01f;
  const TwoLines lines = two_lines(points);
  CHECK(std::abs(lines.radius - 0.015f) < 1e-6f);
  CHECK(std::abs(lines.slope + 0.5f) < 1e-4f);
}

TEST_CASE("points of one height have no line of a cone", "[pieces]") {
  const std::vector<MeridianPoint> level(20, MeridianPoint{0.1f, 0.03f, 1e-6f});
  CHECK_FALSE(std::isfinite(two_lines(level).loss));
}

TEST_CASE("the loss of a point is its squared distance, and ends at nine variances", "[pieces]") {
  TwoLines lines;
  lines.radius = 0.02f, lines.r0 = 0.0f, lines.slope = 1.0f;
  const MeridianPoint p{0.03f, 0.022f, 4e-6f};
  CHECK(std::abs(lines.loss_on_cylinder(p) - 1.0f) < 1e-4f);
  // 8 mm beside a line that rises by 45° are 5.66 mm from it.
  CHECK(std::abs(lines.loss_on_cone(p) - 8.0f) < 1e-3f);
  CHECK(lines.loss_on_cone({0.06f, 0.02f, 4e-6f}) == 9.0f);
}

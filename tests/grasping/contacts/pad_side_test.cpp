#include "contacts/pad_side.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

const Eigen::Vector3d kAlongX = Eigen::Vector3d::UnitX(), kAlongY = Eigen::Vector3d::UnitY();
const Eigen::Vector3d kAlongZ = Eigen::Vector3d::UnitZ();
constexpr double kStep = 0.002;

std::vector<BetweenPads> sorted(std::vector<BetweenPads> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.p_G.y() < b.p_G.y(); });
  return points;
}

/// The upper face of a box 40 mm wide along y, at z = 0, as a sensor above it sees it, and its side
/// towards +y down to a depth.
std::vector<BetweenPads> box_from_above(double depth) {
  std::vector<BetweenPads> points;
  for (double x = -0.008; x <= 0.008; x += kStep) {
    for (double y = -0.02; y <= 0.02; y += kStep) points.push_back({{x, y, 0.0}, -kAlongZ, true});
    for (double z = kStep; z < depth; z += kStep) points.push_back({{x, 0.02, z}, kAlongY, true});
  }
  return sorted(points);
}

}  // namespace

TEST_CASE("a side that was seen is told from a hidden one", "[contacts][points]") {
  const Gripper hand = franka_hand();
  const auto points = box_from_above(0.02);
  const auto seen = pad_side(points, 1.0, 0.0, 0.03, hand);
  CHECK(seen.seen);
  CHECK_FALSE(seen.behind);
  CHECK(seen.n_G.dot(kAlongY) == Approx(1.0));
  CHECK(seen.p_G.y() == Approx(0.02).margin(1e-9));
  CHECK(seen.facing > 0.6);
  // The sensor saw only the edge of the other side.
  const auto hidden = pad_side(points, -1.0, 0.0, 0.03, hand);
  CHECK_FALSE(hidden.seen);
  CHECK_FALSE(hidden.behind);
  CHECK(hidden.n_G.dot(-kAlongY) == Approx(1.0));
  CHECK(hidden.p_G.y() == Approx(-0.02).margin(1e-9));
  CHECK(hidden.facing == Approx(0.0).margin(1e-12));
}

TEST_CASE("nothing tells where a side behind a seen face is", "[contacts][points]") {
  std::vector<BetweenPads> wall;
  for (double x = -0.008; x <= 0.008; x += kStep) {
    for (double z = 0.0; z < 0.03; z += kStep) wall.push_back({{x, 0.01, z}, kAlongY, true});
  }
  CHECK_FALSE(pad_side(wall, 1.0, 0.0, 0.03, franka_hand()).behind);
  CHECK(pad_side(wall, -1.0, 0.0, 0.03, franka_hand()).behind);
}

TEST_CASE("a slope is leaning unless its outermost point lies within the pad",
          "[contacts][points]") {
  // A ball of 25 mm: the tips reach to its widest part or beyond it, or only to 45° above it.
  const double radius = 0.025;
  std::vector<BetweenPads> points;
  for (double t = 0.02; t < 3.0; t += 0.06) {
    for (double around = 0.0; around < 6.28; around += 0.06) {
      const Eigen::Vector3d n =
          std::sin(t) * (std::cos(around) * kAlongX + std::sin(around) * kAlongY) -
          std::cos(t) * kAlongZ;
      if (std::abs(n.x()) * radius < 0.0087) points.push_back({radius * n, n, true});
    }
  }
  const auto to = [&](double tip) {
    std::vector<BetweenPads> above;
    for (const auto& point : points) {
      if (point.p_G.z() < tip) above.push_back(point);
    }
    return pad_side(sorted(above), 1.0, 0.0, tip, franka_hand());
  };
  const auto deep = to(0.012), shallow = to(-radius * std::sqrt(0.5));
  CHECK(deep.inner);
  CHECK(deep.n_G.dot(kAlongY) == Approx(1.0));
  CHECK(shallow.seen);
  CHECK_FALSE(shallow.inner);
  const double lean = std::acos(shallow.n_G.dot(kAlongY));
  CHECK(lean > 0.6);
  CHECK(lean < 1.1);
}

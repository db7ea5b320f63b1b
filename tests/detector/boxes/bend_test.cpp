#include "boxes/bend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

/// The face in the plane z = 0, seen from above.
Face level_face() {
  Face face;
  face.n_C = Eigen::Vector3d::UnitZ();
  return face;
}

/// Points of a dome over 60 by 40 mm, turned about z, with their mean in the plane z = 0.
std::vector<Eigen::Vector3d> dome(double curvature_x, double curvature_y, double turn = 0.0) {
  const Eigen::AngleAxisd R(turn, Eigen::Vector3d::UnitZ());
  std::vector<Eigen::Vector3d> points;
  double mean = 0.0;
  for (double x = -0.03; x < 0.0301; x += 0.001) {
    for (double y = -0.02; y < 0.0201; y += 0.001) {
      const double z = -0.5 * (curvature_x * x * x + curvature_y * y * y);
      points.emplace_back(R * Eigen::Vector3d(x, y, z));
      mean += z;
    }
  }
  for (Eigen::Vector3d& p : points) p.z() -= mean / static_cast<double>(points.size());
  return points;
}

double highest(const std::vector<Eigen::Vector3d>& points) {
  double highest = 0.0;
  for (const Eigen::Vector3d& p : points) highest = std::max(highest, p.z());
  return highest;
}

TEST_CASE(
    "a face bulges by as much as its highest point lies above its plane, however it is turned",
    "[boxes][faces]") {
  for (const auto& [x, y] : {std::pair{4.0, 0.0}, {0.0, 6.0}, {3.0, 5.0}, {4.0, 4.0}}) {
    for (const double turn : {0.0, 0.4, 0.8}) {
      INFO("curvatures " << x << ", " << y << ", turned by " << turn);
      const auto points = dome(x, y, turn);
      const Bend bend = bend_of(level_face(), points);
      CHECK(bend.bulge == Approx(highest(points)).epsilon(0.001));
      CHECK(bend.bulge_std == Approx(0.0).margin(1e-6));
    }
    CHECK(bend_of(level_face(), dome(x, y)).turn >= std::max(0.058 * x, 0.038 * y));
  }
}

TEST_CASE("a flat face, a dent and an even saddle do not bulge, and the dent turns",
          "[boxes][faces]") {
  CHECK(bend_of(level_face(), dome(0.0, 0.0)).bulge == Approx(0.0).margin(1e-9));
  // The saddle is as far below its middle along x as it is above it along y.
  CHECK(bend_of(level_face(), dome(4.0, -9.1)).bulge == 0.0);
  const Bend dent = bend_of(level_face(), dome(-5.0, 0.0));
  CHECK(dent.bulge == 0.0);
  CHECK(dent.turn == Approx(0.3).epsilon(0.06));
  CHECK(bend_of(level_face(), {}).turn == std::numeric_limits<double>::infinity());
}

TEST_CASE("the deviation of a bulge covers what noise that neighbours share makes of a flat face",
          "[boxes][faces]") {
  constexpr int kTrials = 200;
  RandomStream random(5, 0);
  int within = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Eigen::Vector3d> points = dome(0.0, 0.0);
    // Blocks of four by four points have one error. Rows of points have 41.
    std::vector<double> errors(16 * 11);
    for (double& error : errors) error = 0.0005 * test::gaussian(random);
    for (std::size_t k = 0; k < points.size(); ++k) {
      points[k].z() += errors[k / 41 / 4 * 11 + k % 41 / 4];
    }
    const Bend bend = bend_of(level_face(), points);
    within += bend.bulge < 2.0 * bend.bulge_std;
  }
  // A bulge counts only upward, so of normal errors .977 lie below two deviations.
  CHECK(within > 0.94 * kTrials);
}

}  // namespace
}  // namespace quadrille

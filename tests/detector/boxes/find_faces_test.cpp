#include "boxes/find_faces.hpp"

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

/// Points of a dome over 60 by 40 mm, with their mean in the plane z = 0.
std::vector<Eigen::Vector3d> dome(double curvature_x, double curvature_y) {
  std::vector<Eigen::Vector3d> points;
  double mean = 0.0;
  for (double x = -0.03; x < 0.0301; x += 0.001) {
    for (double y = -0.02; y < 0.0201; y += 0.001) {
      points.emplace_back(x, y, -0.5 * (curvature_x * x * x + curvature_y * y * y));
      mean += points.back().z();
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

TEST_CASE("a face bulges by as much as its highest point lies above its plane", "[boxes][faces]") {
  for (const auto& [x, y] : {std::pair{4.0, 0.0}, {0.0, 6.0}, {3.0, 5.0}}) {
    const auto points = dome(x, y);
    const Bend bend = bend_of(level_face(), points);
    CHECK(bend.bulge == Approx(highest(points)).epsilon(0.06));
    CHECK(bend.turn == Approx(std::max(0.06 * x, 0.04 * y)).epsilon(0.06));
  }
}

TEST_CASE("a flat face and a dent do not bulge, and the dent turns", "[boxes][faces]") {
  CHECK(bend_of(level_face(), dome(0.0, 0.0)).bulge == Approx(0.0).margin(1e-9));
  const Bend dent = bend_of(level_face(), dome(-5.0, 0.0));
  CHECK(dent.bulge == Approx(0.0).margin(1e-9));
  CHECK(dent.turn == Approx(0.3).epsilon(0.06));
  CHECK(bend_of(level_face(), {}).turn == std::numeric_limits<double>::infinity());
}

TEST_CASE("a face does not grow over a step onto its neighbour", "[boxes][faces]") {
  constexpr double kSigma = 0.0005, kStep = 0.0035;
  RandomStream random(3, 0);
  PointCloud cloud;
  for (int j = -60; j < 60; ++j) {
    for (int i = -60; i < 60; ++i) {
      const double z = 0.6 + (i < 0 ? 0.0 : kStep) + kSigma * test::gaussian(random);
      cloud.points.emplace_back(Eigen::Vector3f(0.002f * i, 0.002f * j, 1.0f) *
                                static_cast<float>(z));
    }
  }
  const DirectionIndex sight(cloud);
  Eigen::Matrix3d R_CL;
  R_CL << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  FacePatch patch;
  patch.X_CP.linear() = R_CL;
  patch.X_CP.translation() = Eigen::Vector3d(-0.03, 0.0, 0.6);
  patch.half = {0.02, 0.03};
  const auto draft = draft_face({patch, kSigma}, sight);
  REQUIRE(draft);
  const auto face = finished_face(*draft, sight);
  REQUIRE(face);
  CHECK(face->reach(-Eigen::Vector3d::UnitX()).second > 0.065);
  CHECK(face->reach(Eigen::Vector3d::UnitX()).second < 0.004);
}

}  // namespace
}  // namespace quadrille

#include "space/obstacle_points.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include "grasping/random_box.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("points meet a box as one by one", "[space][points]") {
  std::mt19937 random(5);
  const Eigen::AlignedBox3d region(Eigen::Vector3d(-0.1, -0.1, 0.6),
                                   Eigen::Vector3d(0.1, 0.1, 0.8));
  for (const int count : {0, 1, 63, 64, 65, 300}) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) points.push_back(random_point(random, region));
    const ObstaclePoints obstacles(points);
    int met = 0;
    for (int n = 0; n < 300; ++n) {
      const OrientedBox box = random_box(random, region);
      const bool meets =
          std::any_of(points.begin(), points.end(), [&](const auto& p) { return box.contains(p); });
      CHECK(obstacles.meet(box) == meets);
      met += meets;
    }
    CHECK(met < 300);
    if (count == 300) CHECK(met > 50);
  }
}

TEST_CASE("the last of many points is met too", "[space][points]") {
  std::vector<Eigen::Vector3d> points(200, Eigen::Vector3d(1.0, 1.0, 1.0));
  points.back() = Eigen::Vector3d(0.3, 0.2, 0.1);
  OrientedBox box;
  box.p_CB = points.back();
  box.half.setConstant(0.001);
  CHECK(ObstaclePoints(points).meet(box));
}

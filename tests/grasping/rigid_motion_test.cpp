#include "quadrille/grasping/rigid_motion.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "grasping/plans.hpp"
#include "grasping/scenes.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "space/space_mapper.hpp"
#include "view/depth_view.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a moved plan has its grasps, contacts, shapes and proposed views moved", "[frames]") {
  std::mt19937 random(5);
  GraspPlan plan = plan_balls({ball_on_table(0.0, 0.0, 0.03)});
  REQUIRE_FALSE(plan.grasps.empty());
  plan.looks = {{random_pose(random), {4, 2}, 1.25}, {random_pose(random), {7}, 0.5}};
  const Eigen::Isometry3d X_FC = random_pose(random);
  const GraspPlan there = moved(plan, X_FC);
  REQUIRE(there.grasps.size() == plan.grasps.size());
  for (std::size_t n = 0; n < plan.grasps.size(); ++n) {
    const Grasp &a = plan.grasps[n], &b = there.grasps[n];
    CHECK((b.X_CG.matrix() - (X_FC * a.X_CG).matrix()).norm() < 1e-12);
    for (std::size_t c = 0; c < 2; ++c) {
      CHECK((b.contacts_C[c] - X_FC * a.contacts_C[c]).norm() < 1e-15);
    }
    CHECK(b.score == a.score);
  }
  REQUIRE(there.shapes.size() == plan.shapes.size());
  CHECK((there.shapes[0].X_CS.matrix() - (X_FC * plan.shapes[0].X_CS).matrix()).norm() < 1e-12);
  REQUIRE(there.looks.size() == 2);
  for (std::size_t n = 0; n < 2; ++n) {
    const Look &a = plan.looks[n], &b = there.looks[n];
    CHECK((b.X_CK.matrix() - (X_FC * a.X_CK).matrix()).norm() < 1e-12);
    CHECK(b.bodies == a.bodies);
    CHECK(b.gain == a.gain);
  }
}

TEST_CASE("a map moved by whole voxels and quarter turns is the same map", "[frames][occupancy]") {
  const GraspPlan plan = plan_balls({ball_on_table(0.0, 0.0, 0.03)});
  const OccupancyGrid& here = *plan.space;
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  X_FC.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  X_FC.translation() = Eigen::Vector3d(16, -32, 48) * here.resolution();
  const OccupancyGrid there = here.moved(X_FC);
  for (int k = 0; k < here.size().z(); k += 3) {
    for (int j = 0; j < here.size().y(); j += 3) {
      for (int i = 0; i < here.size().x(); i += 3) {
        const Eigen::Vector3d p_C = here.centre(i, j, k);
        REQUIRE(there.at(X_FC * p_C) == here.at(i, j, k));
      }
    }
  }
}

TEST_CASE("a map moved anyhow is free only where the map was free", "[frames][occupancy]") {
  std::mt19937 random(6);
  const GraspPlan plan = plan_balls({ball_on_table(0.0, 0.0, 0.03)});
  const OccupancyGrid& here = *plan.space;
  const Eigen::Isometry3d X_FC = random_pose(random);
  const OccupancyGrid there = here.moved(X_FC);
  int free = 0;
  for (int n = 0; n < 20000; ++n) {
    const Eigen::Vector3d p_C = random_point(random, here.bounds());
    if (there.at(X_FC * p_C) != Voxel::kFree) continue;
    CHECK(here.at(p_C) == Voxel::kFree);
    ++free;
  }
  CHECK(free > 1000);
}

/// The grid of a scene that knows no points.
OccupancyGrid grid_without_points() {
  const std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03)};
  const PointCloud cloud = render(balls);
  const DepthView view(cloud);
  const OccupancyGrid space = *plan_balls(balls).space;
  SpaceMapper mapper(space.bounds(), space.resolution());
  mapper.add(cloud, view);
  return std::move(mapper).take_cleared(view, table_detection().X_CQ.linear().col(2));
}

TEST_CASE("a voxel of a moved map has the most cautious state of all voxels that it overlaps",
          "[frames][occupancy]") {
  std::mt19937 random(7);
  const OccupancyGrid here = grid_without_points();
  const std::vector<Voxel> most_cautious_first = {Voxel::kOccupied, Voxel::kUnknown, Voxel::kClear,
                                                  Voxel::kFree};
  // The box along the axes of C around a voxel of F, tried at nine places along each of them, which
  // are closer to each other than voxels. The outermost lie inside by more than what is rounded.
  const auto expected = [&](const Eigen::Vector3d& p_C, const Eigen::Vector3d& reach) {
    std::size_t rank = most_cautious_first.size() - 1;
    for (int n = 0; n < 729; ++n) {
      const Eigen::Array3d at = Eigen::Array3d(n % 9, n / 9 % 9, n / 81) / 4.0 - 1.0;
      const Voxel state = here.at(Eigen::Vector3d(p_C.array() + at * (reach.array() - 2e-8)));
      const auto found = std::find(most_cautious_first.begin(), most_cautious_first.end(), state);
      rank = std::min(rank, static_cast<std::size_t>(found - most_cautious_first.begin()));
    }
    return most_cautious_first[rank];
  };
  std::map<Voxel, int> seen;
  for (int pose = 0; pose < 5; ++pose) {
    const Eigen::Isometry3d X_FC = random_pose(random), X_CF = X_FC.inverse();
    const OccupancyGrid there = here.moved(X_FC);
    const Eigen::Vector3d reach =
        X_CF.linear().cwiseAbs() * Eigen::Vector3d::Constant(0.5 * there.resolution());
    for (int n = 0; n < 2000; ++n) {
      const Eigen::Vector3d p_F = X_FC * random_point(random, here.bounds());
      const Eigen::Array3i voxel =
          (p_F / there.resolution()).array().floor().cast<int>() - there.corner().array();
      const Eigen::Vector3d centre_F = there.centre(voxel.x(), voxel.y(), voxel.z());
      const Voxel is = there.at(centre_F);
      REQUIRE(is == expected(X_CF * centre_F, reach));
      ++seen[is];
    }
  }
  CHECK(seen.size() == 4);
  CHECK(seen[Voxel::kOccupied] > 50);
}

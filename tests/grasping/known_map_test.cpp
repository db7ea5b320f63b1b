// The hand keeps off the occupied space of a map from elsewhere, and may pass its free space.
#include <octomap/OcTree.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "grasping/known_scene.hpp"
#include "grasping/plans.hpp"
#include "grasping/scenes.hpp"
#include "hand/oriented_box.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "space/outer_middles.hpp"
#include "space/space_mapper.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Makes the largest node of a map about a voxel that is no larger than this occupied, without
/// nodes below it.
/// @return the node's edge [m]
double add_block(octomap::OcTree* tree, const octomap::OcTreeKey& key, double largest) {
  tree->updateNode(key, true);
  unsigned depth = tree->getTreeDepth();
  while (2.0 * tree->getNodeSize(depth) <= largest && depth > 1) {
    octomap::OcTreeNode* parent = tree->search(key, --depth);
    for (unsigned child = 0; child < 8; ++child) {
      if (!tree->nodeChildExists(parent, child)) tree->createNodeChild(parent, child);
      tree->getNodeChild(parent, child)->setLogOdds(3.0f);
    }
    tree->pruneNode(parent);
  }
  tree->updateInnerOccupancy();
  return tree->getNodeSize(depth);
}

}  // namespace

TEST_CASE("hands that meet what a map says is occupied are refused, and no others",
          "[surroundings][map]") {
  const double resolution = GENERATE(0.005, 0.003, 0.02);
  const bool turned = resolution != 0.005;
  CAPTURE(resolution, turned);
  const CanScene scene;
  const Eigen::Isometry3d X_CM = turned ? turned_frame() : Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d X_BC = (scene.X_CW * translation(0.12, 0.0, 0.08)).inverse();
  const Eigen::Vector3d half(0.06, 0.1, 0.08);
  Surroundings known;
  known.map = map_with(X_CM, resolution, around_can(scene, 0.2), [&](const Eigen::Vector3d& p_C) {
    return in_block(X_BC, half, 0.0, p_C) ? 1 : -1;
  });
  const std::vector<Grasp> free = all_hands(scene, {}), kept = all_hands(scene, known);
  // Half the diagonals of the voxels of the map and of the plan.
  const double doubt = 0.5 * std::sqrt(3.0) * (resolution + PlanOptions{}.resolution);
  const auto meets = [&](const Grasp& grasp, double grown) {
    return any_place_in(boxes_of(grasp), [&](const Eigen::Vector3d& p_C) {
      return in_block(X_BC, half, grown, p_C);
    });
  };
  int met = 0, clear = 0, lost = 0;
  // There are thousands.
  for (std::size_t n = 0; n < free.size(); n += 11) {
    const Grasp& grasp = free[n];
    const bool stays = is_among(grasp, kept);
    if (meets(grasp, -doubt)) {
      ++met;
      CHECK_FALSE(stays);
    } else if (!meets(grasp, doubt + 0.002)) {
      ++clear;
      lost += !stays;
    }
  }
  CAPTURE(free.size(), kept.size(), met, clear, lost);
  CHECK(met > 20);
  CHECK(clear > 20);
  // A search ends after many tries, and those that fail early count less.
  CHECK(5 * lost < clear);
  for (std::size_t n = 0; n < kept.size(); n += 11) CHECK_FALSE(meets(kept[n], -doubt));
  // No hand has as much as a corner in a voxel of the map.
  const auto in_voxel = [&](const Eigen::Vector3d& p_C) {
    const octomap::OcTreeNode* node = known.map.tree->search(octo_point(X_CM.inverse() * p_C));
    return node != nullptr && known.map.tree->isNodeOccupied(node);
  };
  for (std::size_t n = 0; n < kept.size(); n += 11) {
    std::vector<OrientedBox> boxes = boxes_of(kept[n]);
    for (OrientedBox& box : boxes) box = box.inflated(-1e-5);
    CHECK_FALSE(any_place_in(boxes, in_voxel));
  }
}

TEST_CASE("each occupied voxel of a map, however small and turned, is in the plan's map",
          "[surroundings][map]") {
  std::mt19937 random(11);
  const double resolution = GENERATE(0.001, 0.003, 0.005, 0.012);
  const Eigen::AlignedBox3d region(Eigen::Vector3d(-0.1, -0.1, 0.5),
                                   Eigen::Vector3d(0.1, 0.1, 0.7));
  for (int n = 0; n < 50; ++n) {
    const Eigen::Isometry3d X_CM = random_pose(random);
    const Eigen::Vector3d p_C = random_point(random, region);
    auto tree = std::make_shared<octomap::OcTree>(resolution);
    const octomap::point3d p_M = octo_point(X_CM.inverse() * p_C);
    tree->updateNode(p_M, true);
    SpaceMapper mapper({region.min().array() - 0.05, region.max().array() + 0.05}, 0.005);
    CHECK(mapper.add({tree, X_CM}));
    const OccupancyGrid grid = std::move(mapper).take();
    const octomap::point3d m = tree->keyToCoord(tree->coordToKey(p_M));
    const Eigen::Vector3d middle_C = X_CM * Eigen::Vector3d(m.x(), m.y(), m.z());
    CHECK(grid.at(middle_C) == Voxel::kOccupied);
    // Nothing else becomes occupied than what is near.
    const double reach = 0.5 * std::sqrt(3.0) * (resolution + 0.005) + 1e-6;
    int far = 0;
    for (int k = 0; k < grid.size().z(); ++k) {
      for (int j = 0; j < grid.size().y(); ++j) {
        for (int i = 0; i < grid.size().x(); ++i) {
          if (grid.at(i, j, k) == Voxel::kUnknown) continue;
          far += (grid.centre(i, j, k) - middle_C).norm() > reach;
        }
      }
    }
    CHECK(far == 0);
  }
}

TEST_CASE("a large block of tiny voxels takes as little work as the plan's own voxels",
          "[surroundings][map]") {
  std::mt19937 random(12);
  // If all voxels of the block, or of its faces, were asked, this would not end.
  const double resolution = GENERATE(0.003, 1e-5, 2e-6);
  const Eigen::AlignedBox3d region(Eigen::Vector3d(-0.1, -0.1, 0.5),
                                   Eigen::Vector3d(0.1, 0.1, 0.7));
  auto tree = std::make_shared<octomap::OcTree>(resolution);
  const octomap::OcTreeKey key = tree->coordToKey(octomap::point3d(0.0f, 0.0f, 0.0f));
  const double edge = add_block(tree.get(), key, 0.08);
  REQUIRE(edge > 0.04);
  const Eigen::AlignedBox3d block_M(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(edge));
  const Eigen::Isometry3d X_MB(Eigen::Translation3d(block_M.center()));
  const Eigen::Isometry3d X_CM = Eigen::Translation3d(0.003, 0.001, 0.602) *
                                 Eigen::Quaterniond(turned_frame().linear()) * X_MB.inverse();
  SpaceMapper mapper(region, 0.005);
  REQUIRE(mapper.add({tree, X_CM}));
  const OccupancyGrid grid = std::move(mapper).take();
  // Voxels at the faces of the block, which are hardest to find.
  std::uniform_int_distribution<int> any(0, static_cast<int>(std::lround(edge / resolution)) - 1);
  int lost = 0;
  for (int n = 0; n < 20000; ++n) {
    Eigen::Array3d at(any(random), any(random), any(random));
    at[n % 3] = n % 2 == 0 ? 0 : any.b();
    const Eigen::Vector3d middle_C = X_CM * Eigen::Vector3d(resolution * (at + 0.5));
    lost += grid.at(middle_C) != Voxel::kOccupied;
  }
  CHECK(lost == 0);
  int far = 0;
  for (int k = 0; k < grid.size().z(); ++k) {
    for (int j = 0; j < grid.size().y(); ++j) {
      for (int i = 0; i < grid.size().x(); ++i) {
        if (grid.at(i, j, k) != Voxel::kOccupied) continue;
        const Eigen::Vector3d p_M = X_CM.inverse() * grid.centre(i, j, k);
        far += block_M.exteriorDistance(p_M) > 0.5 * std::sqrt(3.0) * 0.005;
      }
    }
  }
  CHECK(far == 0);
}

TEST_CASE("of a block of voxels only the outer layers are asked, and each of these once",
          "[surroundings][map]") {
  const Eigen::AlignedBox3d cube(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
  const int n = GENERATE(1, 4, 7, 32);
  const double edge = 1.0 / n;
  std::set<std::array<int, 3>> asked;
  int visits = 0;
  each_outer_middle(cube, cube, edge, edge, [&](const Eigen::Vector3d& p) {
    ++visits;
    asked.insert(
        {static_cast<int>(n * p.x()), static_cast<int>(n * p.y()), static_cast<int>(n * p.z())});
  });
  // Two layers on each side.
  const int inner = std::max(n - 4, 0);
  CHECK(visits == n * n * n - inner * inner * inner);
  CHECK(asked.size() == static_cast<std::size_t>(visits));
}

TEST_CASE("of a map that is too fine to keep hands off its own voxels a warning tells",
          "[surroundings][map]") {
  const CanScene scene;
  const double resolution = GENERATE(0.004, 0.0002);
  Surroundings known;
  auto tree = std::make_shared<octomap::OcTree>(resolution);
  const Eigen::Vector3d beside_C = scene.X_CW * Eigen::Vector3d(0.12, 0.0, 0.08);
  const Eigen::Isometry3d X_CM(Eigen::Translation3d(beside_C) *
                               Eigen::Quaterniond(turned_frame().linear()));
  tree->updateNode(octo_point(X_CM.inverse() * beside_C), true);
  known.map = {tree, X_CM};
  const GraspPlan plan = plan_scene(scene, known, UnknownPolicy::kWeighed);
  const auto tells = [](const std::string& warning) {
    return warning.find("the voxels of the given map are too small") == 0;
  };
  CHECK(std::count_if(plan.warnings.begin(), plan.warnings.end(), tells) ==
        (resolution < 0.001 ? 1 : 0));
}

TEST_CASE("free nodes of a map make free what no view tells, and nothing else",
          "[surroundings][map]") {
  const double resolution = GENERATE(0.008, 0.01);
  const CanScene scene;
  const Eigen::Isometry3d X_WC = scene.X_CW.inverse();
  const auto is_free = [&](const Eigen::Vector3d& p_C, double grown) {
    const Eigen::Vector3d p = X_WC * p_C;
    return p.z() > grown &&
           !(std::hypot(p.x(), p.y()) < kCanRadius + grown && p.z() < kCanHeight + grown);
  };
  Surroundings known;
  known.map = map_with(turned_frame(), resolution, around_can(scene, 0.35),
                       [&](const Eigen::Vector3d& p_C) { return is_free(p_C, 0.02) ? 0 : -1; });
  const GraspPlan alone = plan_scene(scene, {}, UnknownPolicy::kObstacle);
  const GraspPlan told = plan_scene(scene, known, UnknownPolicy::kObstacle);
  REQUIRE(alone.space);
  REQUIRE(told.space);
  REQUIRE(alone.space->size() == told.space->size());
  int freed = 0, wrong = 0;
  for (std::size_t n = 0; n < alone.space->states().size(); ++n) {
    const Voxel before = alone.space->states()[n], after = told.space->states()[n];
    const bool told_by_view = before == Voxel::kOccupied || before == Voxel::kFree;
    wrong += (told_by_view && after != before) || (!told_by_view && after == Voxel::kOccupied);
    freed += before == Voxel::kUnknown && after == Voxel::kFree;
  }
  CHECK(wrong == 0);
  CHECK(freed > 2000);
  const Eigen::Vector3d behind_C = scene.X_CW * Eigen::Vector3d(0.0, 0.07, 0.04);
  CHECK(alone.space->at(behind_C) == Voxel::kUnknown);
  CHECK(told.space->at(behind_C) == Voxel::kFree);
  const Eigen::Vector3d inside_C = scene.X_CCan.translation();
  CHECK(told.space->at(inside_C) == Voxel::kUnknown);
  const std::size_t before = all_hands(scene, {}, UnknownPolicy::kObstacle).size();
  const std::size_t after = all_hands(scene, known, UnknownPolicy::kObstacle).size();
  CAPTURE(before, after);
  CHECK(after > before + 20);
}

TEST_CASE("an empty map, or one of other places, changes nothing", "[surroundings][map]") {
  const CanScene scene;
  const GraspPlan plain = plan_scene(scene, {}, UnknownPolicy::kWeighed);
  REQUIRE_FALSE(plain.grasps.empty());
  Surroundings known;
  known.map.tree = std::make_shared<octomap::OcTree>(0.01);
  check_same_grasps(plan_scene(scene, known, UnknownPolicy::kWeighed), plain);
  auto far = std::make_shared<octomap::OcTree>(0.01);
  far->updateNode(octomap::point3d(50.0f, 50.0f, 50.0f), true);
  known.map.tree = far;
  check_same_grasps(plan_scene(scene, known, UnknownPolicy::kWeighed), plain);
  // A map whose own bounds end before the scene begins.
  auto small = std::make_shared<octomap::OcTree>(1e-6);
  small->updateNode(octomap::point3d(0.001f, 0.0f, 0.0f), true);
  known.map = {small, Eigen::Isometry3d(Eigen::Translation3d(10.0, 0.0, 0.0))};
  check_same_grasps(plan_scene(scene, known, UnknownPolicy::kWeighed), plain);
}

TEST_CASE("what a map shows of the target itself is not in the way", "[surroundings][map]") {
  const CanScene scene;
  const double resolution = GENERATE(0.005, 0.003);
  const Eigen::Isometry3d X_WC = scene.X_CW.inverse();
  Surroundings known;
  known.map = map_with(
      turned_frame(), resolution, around_can(scene, 0.15), [&](const Eigen::Vector3d& p_C) {
        const Eigen::Vector3d p = X_WC * p_C;
        const bool in_can =
            std::hypot(p.x(), p.y()) < kCanRadius && p.z() > 0.0 && p.z() < kCanHeight;
        return in_can ? 1 : -1;
      });
  const std::vector<Grasp> free = all_hands(scene, {}), kept = all_hands(scene, known);
  CAPTURE(free.size(), kept.size());
  REQUIRE(free.size() > 50);
  CHECK(static_cast<double>(count_among(free, kept)) > 0.8 * static_cast<double>(free.size()));
  CHECK_FALSE(plan_scene(scene, known, UnknownPolicy::kWeighed).grasps.empty());
}

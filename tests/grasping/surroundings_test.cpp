// What is known of a scene besides the cloud: the robot, a support, a map, what the hand carries.
#include "quadrille/grasping/surroundings.hpp"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "grasping/plans.hpp"
#include "hand/hand.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/rigid_motion.hpp"
#include "quadrille/grasping/shape.hpp"
#include "space/space_mapper.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/error_of.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kCanRadius = 0.03, kCanHeight = 0.12;

/// A can on a table, and, if it is wanted, a robot's finger that hangs into the picture, or another
/// can. W has its origin at the foot of the can and z upwards.
struct CanScene {
  Eigen::Isometry3d X_CW = world_seen_from({0.0, -0.55, 0.4});
  Eigen::Isometry3d X_CCan = X_CW * translation(0.0, 0.0, 0.5 * kCanHeight);
  Eigen::Isometry3d X_CFinger = X_CW * translation(0.06, -0.07, 0.12);
  Eigen::Vector3d finger_size{0.02, 0.02, 0.16};
  Eigen::Isometry3d X_CNeighbour = X_CW * translation(0.11, 0.0, 0.5 * kCanHeight);
  bool with_table = true, with_finger = false, with_neighbour = false;

  PointCloud cloud() const {
    std::vector<Patch> patches = can(X_CCan, kCanRadius, kCanHeight);
    const auto add = [&](const std::vector<Patch>& more) {
      patches.insert(patches.end(), more.begin(), more.end());
    };
    if (with_table) add({rectangle(X_CW, 1.2, 0.9)});
    if (with_finger) add(box(X_CFinger, finger_size));
    if (with_neighbour) add(can(X_CNeighbour, kCanRadius, kCanHeight));
    Camera camera;
    camera.noise = 0.0003;
    return render(patches, camera);
  }

  std::vector<Detection> detections() const {
    std::vector<Detection> found = {cylinder_detection(X_CCan, kCanRadius, kCanHeight, 1)};
    if (with_neighbour) {
      found.push_back(cylinder_detection(X_CNeighbour, kCanRadius, kCanHeight, 2));
    }
    if (with_table) {
      Detection table = table_detection();
      table.X_CQ = X_CW;
      table.extent_Q = {Eigen::Vector3d(-0.6, -0.45, 0.0), Eigen::Vector3d(0.6, 0.45, 0.0)};
      found.push_back(table);
    }
    return found;
  }

  RobotShapes finger() const {
    RobotShapes robot;
    SolidShape shape;
    shape.kind = "box";
    shape.X_CS = X_CFinger;
    shape.dimensions = {finger_size.x(), finger_size.y(), finger_size.z()};
    robot.shapes = {shape};
    robot.padding = 0.005;
    return robot;
  }
};

PlanOptions policy_of(UnknownPolicy policy) {
  PlanOptions options;
  options.unknown = policy;
  options.clear_above = false;
  options.min_score = 0.0;
  return options;
}

/// All hands that pass every check, however alike they are. None is kept, so that none keeps others
/// from being tried.
std::vector<Grasp> all_hands(const CanScene& scene, const Surroundings& known,
                             UnknownPolicy policy = UnknownPolicy::kFree, GraspQuery query = {}) {
  std::vector<Grasp> hands;
  query.ids = {1};
  query.accept = [&](const Grasp& grasp) {
    hands.push_back(grasp);
    return false;
  };
  plan_grasps(scene.cloud(), scene.detections(), franka_hand(), policy_of(policy), known, query);
  return hands;
}

GraspPlan plan_scene(const CanScene& scene, const Surroundings& known,
                     UnknownPolicy policy = UnknownPolicy::kFree, const GraspQuery& query = {}) {
  return plan_grasps(scene.cloud(), scene.detections(), franka_hand(), policy_of(policy), known,
                     query);
}

bool is_among(const Grasp& grasp, const std::vector<Grasp>& hands) {
  return std::any_of(hands.begin(), hands.end(), [&](const Grasp& other) {
    return (other.X_CG.matrix() - grasp.X_CG.matrix()).norm() < 1e-6;
  });
}

std::size_t count_among(const std::vector<Grasp>& some, const std::vector<Grasp>& hands) {
  return static_cast<std::size_t>(
      std::count_if(some.begin(), some.end(), [&](const Grasp& g) { return is_among(g, hands); }));
}

std::vector<OrientedBox> boxes_of(const Grasp& grasp) {
  const SweptHand hand =
      sweep_hand(franka_hand(), grasp.X_CG, grasp.preshape, grasp.width, grasp.approach);
  return {hand.fingers[0], hand.fingers[1], hand.palm, hand.closing[0], hand.closing[1]};
}

/// Samples boxes every few millimetres, with their faces, until a place is found as wanted.
template <class Wanted>
bool any_place_in(const std::vector<OrientedBox>& boxes, const Wanted& wanted) {
  constexpr double kStep = 0.003;
  for (const OrientedBox& box : boxes) {
    const Eigen::Array3i steps = (2.0 * box.half.array() / kStep).ceil().cast<int>().max(1);
    for (int i = 0; i <= steps.x(); ++i) {
      for (int j = 0; j <= steps.y(); ++j) {
        for (int k = 0; k <= steps.z(); ++k) {
          const Eigen::Array3d share = Eigen::Array3d(i, j, k) / steps.cast<double>();
          const Eigen::Vector3d p_B = box.half.array() * (2.0 * share - 1.0);
          if (wanted(Eigen::Vector3d(box.p_CB + box.R_CB * p_B))) return true;
        }
      }
    }
  }
  return false;
}

bool in_block(const Eigen::Isometry3d& X_BC, const Eigen::Vector3d& half, double grown,
              const Eigen::Vector3d& p_C) {
  return ((X_BC * p_C).cwiseAbs().array() <= half.array() + grown).all();
}

octomap::point3d octo_point(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// A map in frame M of what state_of() says of places in C: 1 occupied, 0 free, -1 unknown.
template <class State>
KnownMap map_with(const Eigen::Isometry3d& X_CM, double resolution,
                  const Eigen::AlignedBox3d& region_C, const State& state_of) {
  auto tree = std::make_shared<octomap::OcTree>(resolution);
  const Eigen::AlignedBox3d region_M = region_C.transformed(X_CM.inverse());
  const Eigen::Array3d low = (region_M.min().array() / resolution).floor();
  const Eigen::Array3i size =
      ((region_M.max().array() / resolution).ceil() - low).template cast<int>();
  for (int i = 0; i < size.x(); ++i) {
    for (int j = 0; j < size.y(); ++j) {
      for (int k = 0; k < size.z(); ++k) {
        const Eigen::Vector3d middle_M = resolution * (low + Eigen::Array3d(i, j, k) + 0.5);
        const int state = state_of(Eigen::Vector3d(X_CM * middle_M));
        if (state >= 0) tree->updateNode(octo_point(middle_M), state == 1, true);
      }
    }
  }
  tree->updateInnerOccupancy();
  tree->prune();
  return {tree, X_CM};
}

Eigen::AlignedBox3d around_can(const CanScene& scene, double reach) {
  return Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-reach), Eigen::Vector3d::Constant(reach))
      .transformed(scene.X_CCan);
}

Eigen::Isometry3d turned_frame() {
  return Eigen::Translation3d(0.313, -0.207, 0.411) *
         Eigen::AngleAxisd(0.8, Eigen::Vector3d(2, -1, 3).normalized());
}

double height_in(const CanScene& scene, const Eigen::Vector3d& p_C) {
  return (scene.X_CW.inverse() * p_C).z();
}

/// The lowest corner of the hand on its way in and at the grasp [m].
double lowest_corner(const Grasp& grasp, const CanScene& scene) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const OrientedBox& box : boxes_of(grasp)) {
    for (int n = 0; n < 8; ++n) {
      const Eigen::Vector3d corner =
          box.half.cwiseProduct(Eigen::Vector3d(n & 1 ? 1 : -1, n & 2 ? 1 : -1, n & 4 ? 1 : -1));
      lowest = std::min(lowest, height_in(scene, box.p_CB + box.R_CB * corner));
    }
  }
  return lowest;
}

}  // namespace

TEST_CASE("a robot's finger in the picture costs no grasp, if it is known",
          "[surroundings][robot]") {
  CanScene scene;
  const std::vector<Grasp> clean = all_hands(scene, {});
  scene.with_finger = true;
  Surroundings known;
  const std::vector<Grasp> obstructed = all_hands(scene, known);
  known.robot = scene.finger();
  const std::vector<Grasp> told = all_hands(scene, known);
  CAPTURE(clean.size(), obstructed.size(), told.size());
  REQUIRE(clean.size() > 50);
  CHECK(static_cast<double>(count_among(clean, obstructed)) <
        0.8 * static_cast<double>(clean.size()));
  CHECK(static_cast<double>(count_among(clean, told)) > 0.97 * static_cast<double>(clean.size()));
}

TEST_CASE("nothing is found or planned on the robot, if it is known", "[surroundings][robot]") {
  CanScene scene;
  scene.with_finger = true;
  const PointCloud cloud = scene.cloud();
  Surroundings known;
  const auto on_finger = [&](const GraspPlan& plan) {
    return std::count_if(plan.grasps.begin(), plan.grasps.end(), [&](const Grasp& grasp) {
      return std::any_of(grasp.contacts_C.begin(), grasp.contacts_C.end(), [&](const auto& p_C) {
        return in_block(scene.X_CFinger.inverse(), 0.5 * scene.finger_size, 0.005, p_C);
      });
    });
  };
  const auto planned = [&](const PointCloud& seen) {
    const DetectionResult found = detect(seen);
    return plan_grasps(cloud, found.detections, franka_hand(), policy_of(UnknownPolicy::kFree),
                       known, {}, found.boxes, found.bodies);
  };
  // The finger is something that could be held.
  CHECK(on_finger(planned(cloud)) > 0);
  known.robot = scene.finger();
  const GraspPlan told = planned(known.robot.taken_from(cloud));
  CHECK(on_finger(told) == 0);
  CHECK_FALSE(told.grasps.empty());
}

TEST_CASE("space behind the robot stays unknown, and its own space is free",
          "[surroundings][robot]") {
  CanScene scene;
  scene.with_finger = true;
  Surroundings known;
  known.robot = scene.finger();
  const GraspPlan plan = plan_scene(scene, known, UnknownPolicy::kObstacle);
  const GraspPlan untold = plan_scene(scene, {}, UnknownPolicy::kObstacle);
  REQUIRE(plan.space);
  REQUIRE(untold.space);
  int inside = 0, free = 0, behind = 0, unknown = 0, occupied = 0;
  for (double z = -0.05; z <= 0.05; z += 0.005) {
    const Eigen::Vector3d middle_C = scene.X_CFinger * Eigen::Vector3d(0.0, 0.0, z);
    if (!plan.space->bounds().contains(middle_C)) continue;
    ++inside;
    free += plan.space->at(middle_C) == Voxel::kFree;
    // The side towards the camera.
    for (double depth = -0.02; depth <= 0.02; depth += 0.001) {
      const Eigen::Vector3d p_C = middle_C + depth * middle_C.normalized();
      occupied += untold.space->at(p_C) == Voxel::kOccupied;
      CHECK(plan.space->at(p_C) != Voxel::kOccupied);
    }
    const Eigen::Vector3d behind_C = middle_C + 0.04 * middle_C.normalized();
    if (!plan.space->bounds().contains(behind_C) || height_in(scene, behind_C) < 0.02) continue;
    ++behind;
    unknown += plan.space->at(behind_C) == Voxel::kUnknown;
  }
  CHECK(inside > 10);
  CHECK(free == inside);
  CHECK(behind > 5);
  CHECK(unknown == behind);
  CHECK(occupied > 10);
}

TEST_CASE("no hand goes below a support that is known, though nobody saw it",
          "[surroundings][support]") {
  CanScene scene;
  scene.with_table = false;
  const std::vector<Grasp> free = all_hands(scene, {});
  const auto below = [&](const Grasp& grasp) { return lowest_corner(grasp, scene) < -0.001; };
  REQUIRE(std::count_if(free.begin(), free.end(), below) > 10);
  Surroundings known;
  KnownSupport support;
  support.n_C = scene.X_CW.linear().col(2);
  support.offset = support.n_C.dot(scene.X_CW.translation());
  known.support = support;
  const std::vector<Grasp> kept = all_hands(scene, known);
  CHECK_FALSE(kept.empty());
  CHECK(std::none_of(kept.begin(), kept.end(), below));
  const GraspPlan plan = plan_scene(scene, known);
  REQUIRE_FALSE(plan.grasps.empty());
  CHECK(std::none_of(plan.grasps.begin(), plan.grasps.end(), below));
  // The support is nothing to hold, and no shape of the plan.
  for (const Grasp& grasp : plan.grasps) CHECK(grasp.target == 1);
  CHECK(plan.shapes.size() == plan_scene(scene, {}).shapes.size());
}

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

TEST_CASE("what is fixed to the hand touches neither the table nor a neighbour",
          "[surroundings][attached]") {
  CanScene scene;
  scene.with_neighbour = true;
  // A long thing beside the hand, across the direction in which it closes.
  const Eigen::AlignedBox3d held(Eigen::Vector3d(0.05, -0.015, -0.1),
                                 Eigen::Vector3d(0.14, 0.015, -0.035));
  const auto touches = [&](const Grasp& grasp) {
    bool any = false;
    for (double back = 0.0; back <= grasp.approach; back += 0.005) {
      Eigen::Isometry3d X_CG = grasp.X_CG;
      X_CG.translation() -= back * grasp.X_CG.linear().col(2);
      const OrientedBox box = box_between(X_CG, held.min(), held.max());
      any |= any_place_in({box}, [&](const Eigen::Vector3d& p_C) {
        const Eigen::Vector3d p_N = scene.X_CNeighbour.inverse() * p_C;
        const bool in_neighbour = std::hypot(p_N.x(), p_N.y()) < kCanRadius - 0.001 &&
                                  std::abs(p_N.z()) < 0.5 * kCanHeight - 0.001;
        return in_neighbour || height_in(scene, p_C) < -0.001;
      });
    }
    return any;
  };
  // There are thousands, of which some are as good as all.
  const auto some_hands = [&](const GraspQuery& asked) {
    const std::vector<Grasp> all = all_hands(scene, {}, UnknownPolicy::kFree, asked);
    std::vector<Grasp> some;
    for (std::size_t n = 0; n < all.size(); n += 13) some.push_back(all[n]);
    return some;
  };
  const std::vector<Grasp> bare = some_hands({});
  const auto touching = std::count_if(bare.begin(), bare.end(), touches);
  CAPTURE(bare.size(), touching);
  REQUIRE(touching > 10);
  REQUIRE(static_cast<std::size_t>(touching) < bare.size());
  GraspQuery query;
  SolidShape shape;
  shape.kind = "box";
  shape.X_CS.translation() = held.center();
  shape.dimensions = {held.sizes().x(), held.sizes().y(), held.sizes().z()};
  query.attached = {with_geometry(shape)};
  const std::vector<Grasp> laden = some_hands(query);
  CHECK_FALSE(laden.empty());
  CHECK(std::none_of(laden.begin(), laden.end(), touches));
  // It may not touch shapes that are given, either.
  SolidShape wall = shape;
  wall.X_CS = scene.X_CW * translation(0.0, 0.0, 0.4);
  wall.dimensions = {1.0, 1.0, 0.3};
  query.obstacles = {with_geometry(wall)};
  const auto in_wall = [&](const Grasp& grasp) {
    const OrientedBox box = box_between(grasp.X_CG, held.min(), held.max());
    return any_place_in({box}, [&](const Eigen::Vector3d& p_C) {
      return in_block(wall.X_CS.inverse(), Eigen::Vector3d(0.5, 0.5, 0.15), -0.001, p_C);
    });
  };
  const std::vector<Grasp> walled = some_hands(query);
  CHECK(std::none_of(walled.begin(), walled.end(), in_wall));
}

TEST_CASE("surroundings come back when they are moved there and back", "[surroundings][frames]") {
  std::mt19937 random(12);
  CanScene scene;
  scene.with_finger = true;
  Surroundings known;
  known.views = {scene.cloud()};
  known.robot = scene.finger();
  known.support = KnownSupport{Eigen::Vector3d(0.6, 0.0, 0.8), 0.3};
  known.map = {std::make_shared<octomap::OcTree>(0.01), turned_frame()};
  const Eigen::Isometry3d X_FC = random_pose(random);
  const Surroundings there = moved(known, X_FC);
  // A point on the plane stays on it.
  const Eigen::Vector3d on_plane(0.5, 0.7, 0.0);
  REQUIRE(known.support->n_C.dot(on_plane) == Approx(known.support->offset));
  CHECK(there.support->n_C.dot(X_FC * on_plane) == Approx(there.support->offset));
  CHECK((there.support->n_C - X_FC.linear() * known.support->n_C).norm() < 1e-12);
  CHECK(there.views[0].viewpoint.isApprox(X_FC.translation()));
  CHECK(there.map.tree == known.map.tree);
  CHECK((there.map.X_CM.matrix() - (X_FC * known.map.X_CM).matrix()).norm() < 1e-12);
  const Surroundings back = moved(there, X_FC.inverse());
  CHECK((back.support->n_C - known.support->n_C).norm() < 1e-12);
  CHECK(back.support->offset == Approx(known.support->offset));
  CHECK((back.robot.shapes[0].X_CS.matrix() - known.robot.shapes[0].X_CS.matrix()).norm() < 1e-12);
  CHECK((back.map.X_CM.matrix() - known.map.X_CM.matrix()).norm() < 1e-12);
  for (std::size_t k = 0; k < known.views[0].points.size(); k += 97) {
    const Eigen::Vector3f p = known.views[0].points[k];
    if (p.allFinite()) CHECK((back.views[0].points[k] - p).norm() < 1e-6f);
  }
  CHECK(error_of([&] { back.check(); }).empty());
}

TEST_CASE("plans with all that is known turn with the frame", "[surroundings][frames]") {
  CanScene scene;
  scene.with_finger = true;
  Surroundings known;
  known.robot = scene.finger();
  KnownSupport support;
  support.n_C = scene.X_CW.linear().col(2);
  support.offset = support.n_C.dot(scene.X_CW.translation());
  known.support = support;
  const Eigen::Isometry3d X_BC = (scene.X_CW * translation(0.12, 0.0, 0.08)).inverse();
  known.map =
      map_with(turned_frame(), 0.005, around_can(scene, 0.25), [&](const Eigen::Vector3d& p_C) {
        return in_block(X_BC, {0.06, 0.1, 0.08}, 0.0, p_C) ? 1 : -1;
      });
  const GraspPlan here = plan_scene(scene, known);
  REQUIRE_FALSE(here.grasps.empty());
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  X_FC.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  X_FC.translation() = Eigen::Vector3d(0.25, -0.5, 1.0);
  std::vector<Detection> detections = scene.detections();
  for (Detection& d : detections) d = moved(d, X_FC);
  const GraspPlan there = plan_grasps(moved(scene.cloud(), X_FC), detections, franka_hand(),
                                      policy_of(UnknownPolicy::kFree), moved(known, X_FC));
  REQUIRE_FALSE(there.grasps.empty());
  CHECK(there.grasps.front().score == Approx(here.grasps.front().score).epsilon(0.1));
  const double share =
      static_cast<double>(there.grasps.size()) / static_cast<double>(here.grasps.size());
  CHECK(share > 0.6);
  CHECK(share < 1.6);
  // The block is where it was.
  for (const Grasp& grasp : there.grasps) {
    const Grasp back = moved(grasp, X_FC.inverse());
    CHECK_FALSE(any_place_in(boxes_of(back), [&](const Eigen::Vector3d& p_C) {
      return in_block(X_BC, {0.06, 0.1, 0.08}, -0.009, p_C);
    }));
    CHECK(lowest_corner(back, scene) > -0.001);
  }
}

TEST_CASE("surroundings that make no sense are refused", "[surroundings][hostile]") {
  const CanScene scene;
  Surroundings known;
  CHECK(error_of([&] { known.check(); }).empty());
  for (const Eigen::Vector3d& n : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 1.1),
                                   Eigen::Vector3d(0, 0, std::nan(""))}) {
    known.support = KnownSupport{n, 0.0};
    CHECK(error_of([&] { known.check(); }).find("support") != std::string::npos);
    CHECK_THROWS_AS(plan_scene(scene, known), std::invalid_argument);
  }
  known.support = KnownSupport{Eigen::Vector3d::UnitZ(), HUGE_VAL};
  CHECK(error_of([&] { known.check(); }).find("support") != std::string::npos);
  known.support.reset();
  known.robot = scene.finger();
  known.robot.padding = -1.0;
  CHECK(error_of([&] { known.check(); }).find("padding") != std::string::npos);
  known.robot = scene.finger();
  known.robot.shapes[0].dimensions.pop_back();
  CHECK(error_of([&] { known.check(); }).find("dimensions") != std::string::npos);
  CHECK_THROWS_AS(plan_scene(scene, known), std::invalid_argument);
}

TEST_CASE("a map at a pose that is none is refused", "[surroundings][hostile]") {
  Surroundings known;
  known.map.tree = std::make_shared<octomap::OcTree>(0.01);
  known.map.X_CM.translation().x() = std::nan("");
  CHECK(error_of([&] { known.check(); }).find("map") != std::string::npos);
}

#pragma once

// A can on a table of which something is known besides the cloud, and the hands that reach it.

#include <octomap/OcTree.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "grasping/scenes.hpp"
#include "hand/hand.hpp"
#include "hand/oriented_box.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

inline constexpr double kCanRadius = 0.03, kCanHeight = 0.12;

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

inline PlanOptions policy_of(UnknownPolicy policy) {
  PlanOptions options;
  options.unknown = policy;
  options.clear_above = false;
  options.min_score = 0.0;
  return options;
}

/// All hands that pass every check, however alike they are. None is kept, so that none keeps others
/// from being tried.
inline std::vector<Grasp> all_hands(const CanScene& scene, const Surroundings& known,
                                    UnknownPolicy policy = UnknownPolicy::kFree,
                                    GraspQuery query = {}) {
  std::vector<Grasp> hands;
  query.ids = {1};
  query.accept = [&](const Grasp& grasp) {
    hands.push_back(grasp);
    return false;
  };
  plan_grasps(scene.cloud(), scene.detections(), franka_hand(), policy_of(policy), known, query);
  return hands;
}

inline GraspPlan plan_scene(const CanScene& scene, const Surroundings& known,
                            UnknownPolicy policy = UnknownPolicy::kFree,
                            const GraspQuery& query = {}) {
  return plan_grasps(scene.cloud(), scene.detections(), franka_hand(), policy_of(policy), known,
                     query);
}

inline bool is_among(const Grasp& grasp, const std::vector<Grasp>& hands) {
  return std::any_of(hands.begin(), hands.end(), [&](const Grasp& other) {
    return (other.X_CG.matrix() - grasp.X_CG.matrix()).norm() < 1e-6;
  });
}

inline std::size_t count_among(const std::vector<Grasp>& some, const std::vector<Grasp>& hands) {
  return static_cast<std::size_t>(
      std::count_if(some.begin(), some.end(), [&](const Grasp& g) { return is_among(g, hands); }));
}

inline std::vector<OrientedBox> boxes_of(const Grasp& grasp) {
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

inline bool in_block(const Eigen::Isometry3d& X_BC, const Eigen::Vector3d& half, double grown,
                     const Eigen::Vector3d& p_C) {
  return ((X_BC * p_C).cwiseAbs().array() <= half.array() + grown).all();
}

inline octomap::point3d octo_point(const Eigen::Vector3d& p) {
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

inline Eigen::AlignedBox3d around_can(const CanScene& scene, double reach) {
  return Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-reach), Eigen::Vector3d::Constant(reach))
      .transformed(scene.X_CCan);
}

inline Eigen::Isometry3d turned_frame() {
  return Eigen::Translation3d(0.313, -0.207, 0.411) *
         Eigen::AngleAxisd(0.8, Eigen::Vector3d(2, -1, 3).normalized());
}

inline double height_in(const CanScene& scene, const Eigen::Vector3d& p_C) {
  return (scene.X_CW.inverse() * p_C).z();
}

/// The lowest corner of the hand on its way in and at the grasp [m].
inline double lowest_corner(const Grasp& grasp, const CanScene& scene) {
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

}  // namespace quadrille::test

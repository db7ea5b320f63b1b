// Benchmarks of the grasp planner's kernels, each on its own, on a generated table scene with the
// detector's results.
#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "body/pieces.hpp"
#include "contacts/candidates.hpp"
#include "lab/scoring/frame.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/shape.hpp"
#include "space/collision.hpp"
#include "space/space_mapper.hpp"
#include "view/depth_view.hpp"

namespace quadrille {
namespace {

constexpr double kResolution = 0.005;
constexpr int kEdge = 256;

const PointCloud& cloud() {
  static const PointCloud made =
      scoring::frame_of(scene::make_scene({scene::Family::kTabletop, 61000})).cloud;
  return made;
}

const std::vector<Detection>& detections() {
  static const std::vector<Detection> found = detect(cloud()).detections;
  return found;
}

const DepthView& view() {
  static const DepthView made(cloud(), PlanOptions().baseline, kResolution);
  return made;
}

// The region has 256 voxels along each edge, most of them in the image.
Eigen::AlignedBox3d region() {
  const Eigen::Vector3d low = kResolution * Eigen::Vector3d(-128, -128, 64);
  return {low + Eigen::Vector3d::Constant(0.001),
          low + Eigen::Vector3d::Constant(kEdge * kResolution - 0.001)};
}

OccupancyGrid map_space() {
  SpaceMapper mapper(region(), kResolution);
  mapper.add(cloud(), view());
  return std::move(mapper).take();
}

const OccupancyGrid& grid() {
  static const OccupancyGrid made = map_space();
  return made;
}

/// The first target, with all candidate hands around it.
struct Target {
  CollisionScene scene;
  std::vector<SweptHand> hands;
};

// @param away  moves the hands from the target towards the sensor [m]
Target make_target(bool unknown_blocks, double away) {
  Target target{{ObstacleMap(grid(), unknown_blocks), {}, {}, {}}, {}};
  const Gripper gripper = franka_hand();
  const Body* aim = nullptr;
  std::vector<Body> bodies;
  for (const Detection& d : detections()) {
    if (d.type == QuadricType::kPlane) continue;
    if (const auto body = make_body(d)) bodies.push_back(*body);
  }
  for (const Body& body : bodies) {
    if (!aim && body.bounds_Q().sizes().minCoeff() < gripper.max_opening) aim = &body;
  }
  if (!aim) return target;
  ApproachSpace space;
  for (const Detection& d : detections()) {
    // the table is the largest plane
    if (d.type == QuadricType::kPlane && target.scene.planes.empty()) {
      const Eigen::AlignedBox3d& box = d.extent_Q;
      target.scene.planes.push_back({d.X_CQ, {box.min().head<2>(), box.max().head<2>()}});
      space.up_C = target.scene.planes[0].n_C();
    }
    for (const CollisionShape& shape : make_shapes(d)) {
      if (!aim->contains(shape.X_CS.translation(), 0.006)) {
        target.scene.neighbours.push_back(shape);
      }
    }
  }
  target.scene.target = make_pieces(*aim);
  target.scene.map.carve(*aim, 0.006, [&](const Eigen::Vector3d& p_C) {
    return !target.scene.planes.empty() && target.scene.planes[0].distance(p_C) < 0.0025;
  });
  const std::vector<ContactLine> lines = contact_lines(*aim, gripper, cloud().viewpoint);
  space.view_C = (cloud().viewpoint - aim->centre_C()).normalized();
  space.centre_C = aim->centre_C();
  const SampledApproaches sampled = sample_approaches(lines, space);
  for (const GraspCandidate& c : sampled.candidates) {
    const ContactLine& line = lines[static_cast<std::size_t>(c.line)];
    Eigen::Isometry3d X_CG = grasp_pose(line, c.approach_C, 0.0);
    X_CG.translation() += away * space.view_C;
    target.hands.push_back(sweep_hand(gripper, X_CG, line.opening + 0.01, line.width, 0.05));
  }
  return target;
}

void view_of_cloud(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(DepthView(cloud(), PlanOptions().baseline, kResolution));
  }
}
BENCHMARK(view_of_cloud)->Unit(benchmark::kMillisecond);

void occupancy_of_view(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(map_space());
  state.counters["voxels"] = static_cast<double>(grid().states().size());
}
BENCHMARK(occupancy_of_view)->Unit(benchmark::kMillisecond);

void octree_of_grid(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(grid().to_octree());
}
BENCHMARK(octree_of_grid)->Unit(benchmark::kMillisecond);

void obstacles_of_grid(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(ObstacleMap(grid(), true));
}
BENCHMARK(obstacles_of_grid)->Unit(benchmark::kMillisecond);

void hands_checked(benchmark::State& state) {
  const Target target = make_target(state.range(0) != 0, state.range(1) * 0.001);
  if (target.hands.empty()) return state.SkipWithError("the scene has no target");
  std::size_t free = 0;
  for (auto _ : state) {
    free = 0;
    for (const SweptHand& hand : target.hands) {
      free += !target.scene.palm_obstruction(hand.palm) && !target.scene.finger_obstruction(hand);
    }
  }
  const auto count = static_cast<std::int64_t>(target.hands.size());
  state.SetItemsProcessed(state.iterations() * count);
  state.counters["hands"] = static_cast<double>(count);
  state.counters["free"] = static_cast<double>(free);
}
// The hands are checked at the target, where most are blocked, and in the open, where every test
// has to be made.
BENCHMARK(hands_checked)
    ->ArgNames({"unknown_blocks", "mm_away"})
    ->ArgsProduct({{0, 1}, {0, 150, 300}})
    ->Unit(benchmark::kMillisecond);

void plan_of_scene(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(plan_grasps(cloud(), detections(), franka_hand()));
  }
}
BENCHMARK(plan_of_scene)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quadrille

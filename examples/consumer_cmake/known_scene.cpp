// Plans grasps that keep off what the cloud does not show: a crate and a fence in the robot's cell,
// and a shelf that only its own OctoMap knows. Prints what each of them changes.
//
// The cell is that of the cloud that "quadrille scene cloud.ply --family tabletop --seed 7" makes.
#include <octomap/OcTree.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/grasping/shape.hpp"

// Reads a .ply whose points are three floats each and end the file.
quadrille::PointCloud read_cloud(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string last_line = "end_header\n";
  const std::size_t header = text.find(last_line);
  if (header == std::string::npos) throw std::runtime_error(path + " is no .ply");

  const auto records = std::as_bytes(std::span(text)).subspan(header + last_line.size());
  quadrille::PointLayout layout;
  layout.width = records.size() / layout.point_step;
  return quadrille::read_points(records, layout);
}

// A box along the axes of the cell's frame W, as an obstacle in the camera's frame C.
quadrille::CollisionShape box_in_C(const Eigen::Isometry3d& X_CW, const Eigen::Vector3d& middle_W,
                                   const Eigen::Vector3d& size) {
  return quadrille::with_geometry(
      {"box", X_CW * Eigen::Translation3d(middle_W), {size.x(), size.y(), size.z()}});
}

// The map that the robot has of its cell, in W: a shelf above the left half of the table. To read
// one that a mapper has saved, write std::make_shared<octomap::OcTree>("cell.bt"), and check that
// its size() is not 0, as it is if the file cannot be read.
std::shared_ptr<const octomap::OcTree> map_of_cell() {
  const double voxel = 0.02;
  auto map = std::make_shared<octomap::OcTree>(voxel);
  for (double x = -0.4; x < 0.0; x += voxel) {
    for (double y = -0.2; y < 0.3; y += voxel) map->updateNode(x, y, 0.25, true);
  }
  return map;
}

void print(const std::string& what, const quadrille::GraspPlan& plan) {
  std::cout << what << ": " << plan.grasps.size() << " grasps";
  const auto refused = plan.rejected.find("collision");
  if (refused != plan.rejected.end()) std::cout << ", " << refused->second << " collide";
  if (!plan.grasps.empty()) {
    const quadrille::Grasp& best = plan.grasps.front();
    std::cout << "; the best holds " << best.target << " at " << best.X_CG.translation().transpose()
              << " m, score " << best.score;
  }
  std::cout << '\n';
}

// Says whether a plan still has the best grasp of an earlier one.
void compare(const quadrille::GraspPlan& before, const quadrille::GraspPlan& after) {
  if (before.grasps.empty()) return;
  const bool kept = std::any_of(after.grasps.begin(), after.grasps.end(), [&](const auto& grasp) {
    return grasp.X_CG.isApprox(before.grasps.front().X_CG, 1e-9);
  });
  std::cout << "  the best grasp of before is " << (kept ? "kept" : "refused") << '\n';
}

int main(int argc, char** argv) try {
  if (argc != 2) throw std::invalid_argument("usage: known_scene CLOUD.ply");
  const quadrille::PointCloud cloud = read_cloud(argv[1]);
  const quadrille::DetectionResult found = quadrille::detect(cloud);

  // The camera's pose in W, whose z axis points up from the table. The cloud and the grasps are in
  // the camera's frame C, so what is known in W is placed there.
  const Eigen::Isometry3d X_WC =
      Eigen::Translation3d(0.0, -0.53, 0.43) * Eigen::AngleAxisd(-2.2, Eigen::Vector3d::UnitX());
  const Eigen::Isometry3d X_CW = X_WC.inverse();

  std::cout << std::fixed << std::setprecision(3);
  const quadrille::Gripper hand = quadrille::franka_hand();
  const quadrille::GraspScene scene(cloud, found.detections, hand, {}, {}, found.boxes,
                                    found.bodies);
  const quadrille::GraspPlan alone = scene.plan();
  print("the cloud alone", alone);

  // Obstacles belong to a query: the scene is prepared once, and answers each query with its own.
  quadrille::GraspQuery query;
  query.obstacles = {box_in_C(X_CW, {0.3, 0.1, 0.1}, {0.2, 0.2, 0.2})};
  const quadrille::GraspPlan beside_crate = scene.plan(query);
  print("with a crate", beside_crate);
  compare(alone, beside_crate);

  query.obstacles.push_back(box_in_C(X_CW, {-0.05, 0.0, 0.2}, {0.02, 0.8, 0.4}));
  const quadrille::GraspPlan fenced = scene.plan(query);
  print("with crate and fence", fenced);
  compare(beside_crate, fenced);

  // A map belongs to the scene, since it also says which space is free.
  quadrille::Surroundings known;
  known.map = {map_of_cell(), X_CW};
  const quadrille::GraspScene mapped(cloud, found.detections, hand, {}, known, found.boxes,
                                     found.bodies);
  const quadrille::GraspPlan under_shelf = mapped.plan(query);
  print("with crate, fence and map", under_shelf);
  compare(fenced, under_shelf);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}

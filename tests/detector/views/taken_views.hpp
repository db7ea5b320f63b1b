#pragma once

// Views that a camera takes of a table from places round it, and a memory of them.

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "detector/table_scene.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/view_memory.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

inline constexpr std::int64_t kSecond = 1'000'000;

/// The middle of the table's ball in W.
inline const Eigen::Vector3d kBall_W(-0.2, 0.0, kBall);

/// The table of TableScene in frame W, where z = 0 is the table's top.
inline std::vector<Patch> world_table() {
  std::vector<Patch> patches = TableScene().patches();
  for (Patch& patch : patches) patch.X_CB = TableScene().X_CW.inverse() * patch.X_CB;
  return patches;
}

/// The table without its ball, which is the second patch.
inline std::vector<Patch> world_without_ball() {
  std::vector<Patch> patches = world_table();
  patches.erase(patches.begin() + 1);
  return patches;
}

struct Taken {
  PointCloud cloud;
  Eigen::Isometry3d X_WK;
};

/// Renders what a camera sees that stands at this place and looks at the middle of the table. The
/// cloud is in the camera's frame.
inline Taken taken_from_eye(const std::vector<Patch>& patches_W, const Eigen::Vector3d& eye_W,
                            double noise = 0.001, int width = 160) {
  const Eigen::Isometry3d X_KW = world_seen_from(eye_W);
  std::vector<Patch> patches = patches_W;
  for (Patch& patch : patches) patch.X_CB = X_KW * patch.X_CB;
  Camera camera{width, width * 3 / 4, 1.0 / (width * 300.0 / 320.0)};
  camera.noise = noise;
  return {render(patches, camera), X_KW.inverse()};
}

/// A place 0.65 m above the table, at this angle about the vertical [deg].
inline Eigen::Vector3d eye_at(double degrees, double height = 0.65) {
  const double a = degrees * M_PI / 180.0;
  return {0.8 * std::sin(a), -0.8 * std::cos(a), height};
}

inline Eigen::Isometry3d add_view(ViewMemory& memory, std::int64_t utime, const Taken& view) {
  return memory.add(utime, view.cloud, view.X_WK);
}

/// The remembered views in frame W; no view is of the time that is named.
inline std::vector<PointCloud> views_in_world(const ViewMemory& memory) {
  return memory.others(std::numeric_limits<std::int64_t>::min(), Eigen::Isometry3d::Identity());
}

}  // namespace quadrille::test

// Finds the space behind a target that the target hides.
#include <cmath>

#include "space/obstacle_map.hpp"
#include "view/depth_view.hpp"

namespace quadrille {
namespace {

// A measured point this near to the target's body belongs to the target [m].
constexpr double kTargetNoise = 0.006;

}  // namespace

/// A cone, seen from the sensor, that contains the body's shadow.
struct ObstacleMap::Cone {
  Eigen::Vector3d p_CV, to_body;
  double far, size, angle;

  Cone(const DepthView& view, const Body& body) : p_CV(view.p_CV()) {
    const Eigen::AlignedBox3d bounds = body.bounds_C();
    to_body = bounds.center() - p_CV;
    far = to_body.norm();
    size = 0.5 * bounds.diagonal().norm() + kTargetNoise;
    angle = far > size ? std::asin(size / far) : std::acos(-1.0);
  }

  /// Returns true if the ball around p_C may reach into the cone.
  bool meets(const Eigen::Vector3d& p_C, double radius) const {
    const Eigen::Vector3d to_ball = p_C - p_CV;
    const double here = to_ball.norm();
    if (here <= radius) return true;
    if (here + radius < far - size) return false;
    const double sum = angle + std::asin(radius / here);
    return sum >= std::acos(-1.0) || to_body.dot(to_ball) >= std::cos(sum) * far * here;
  }
};

void ObstacleMap::clear_shadow(const OccupancyGrid& grid, const DepthView& view, const Body& body,
                               const Eigen::AlignedBox3d& region) {
  if (!view.valid() || levels_[0].flags.empty()) return;
  constexpr int kEdge = 1 << (kLevels - 1);
  const Range range = voxels(region);
  const Eigen::Vector3i low = range.first / kEdge, high = range.second / kEdge;
  if ((range.second.array() < 0).any()) return;
  const Cone cone(view, body);
  for (int k = low.z(); k <= high.z(); ++k) {
    for (int j = low.y(); j <= high.y(); ++j) {
      for (int i = low.x(); i <= high.x(); ++i) {
        const Eigen::Vector3i first = kEdge * Eigen::Vector3i(i, j, k);
        const Eigen::Vector3d middle =
            corner_ + resolution_ * (first.cast<double>().array() + 0.5 * kEdge).matrix();
        if (cone.meets(middle, 0.87 * kEdge * resolution_))
          clear_block(grid, view, body, cone, first);
      }
    }
  }
  refresh({kEdge * low, (kEdge * (high.array() + 1) - 1).matrix()});
}

/// Clears one block of the top level, voxel by voxel.
void ObstacleMap::clear_block(const OccupancyGrid& grid, const DepthView& view, const Body& body,
                              const Cone& cone, const Eigen::Vector3i& first) {
  constexpr int kEdge = 1 << (kLevels - 1);
  const auto on_target = [&](const Eigen::Vector3d& p_C) {
    return body.contains(p_C, kTargetNoise);
  };
  for (int n = 0; n < kEdge * kEdge * kEdge; ++n) {
    const int i = first.x() + n % kEdge, j = first.y() + n / kEdge % kEdge;
    const int k = first.z() + n / (kEdge * kEdge);
    if (grid.at(first_.x() + i, first_.y() + j, first_.z() + k) != Voxel::kUnknown) continue;
    const Eigen::Vector3d p_C = centre(i, j, k);
    if (!cone.meets(p_C, resolution_)) continue;
    if (view.hidden_only_by(p_C, 0.5 * resolution_, on_target)) {
      levels_[0].flags[levels_[0].index(i, j, k)] = 0;
    }
  }
}

}  // namespace quadrille

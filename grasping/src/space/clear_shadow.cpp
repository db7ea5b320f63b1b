// Finds the space behind a target that the target hides.
#include <cmath>

#include "space/obstacle_map.hpp"
#include "view/depth_view.hpp"

namespace quadrille {
/// A cone, seen from the sensor, that contains the body's shadow.
struct ObstacleMap::Cone {
  Eigen::Vector3d p_CV, to_body;
  double far, size, angle;

  Cone(const DepthView& view, const Body& body) : p_CV(view.p_CV()) {
    const Eigen::AlignedBox3d bounds = body.bounds_C();
    to_body = bounds.center() - p_CV;
    far = to_body.norm();
    size = 0.5 * bounds.diagonal().norm() + kBodyNoise;
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

void ObstacleMap::clear_shadow(const Body& body, const Eigen::AlignedBox3d& region) {
  if (views_.empty() || blocks_.empty()) return;
  const Range range = voxels(region);
  if ((range.second.array() < 0).any()) return;
  const Range blocks(kEdge * (range.first / kEdge), kEdge * (range.second / kEdge).array() + kEdge);
  for (const DepthView& view : views_) {
    if (view.valid()) clear_shadow(view, body, blocks);
  }
  refresh({blocks.first, blocks.second.array() - 1});
}

void ObstacleMap::clear_shadow(const DepthView& view, const Body& body, const Range& blocks) {
  const Cone cone(view, body);
  each_cube(blocks.first, blocks.second, kEdge, [&](const Eigen::Vector3i& first) {
    const Eigen::Vector3d middle =
        corner_ + resolution_ * (first.cast<double>().array() + 0.5 * kEdge).matrix();
    if (cone.meets(middle, 0.5 * std::sqrt(3.0) * kEdge * resolution_)) {
      clear_block(view, body, cone, first);
    }
  });
}

/// Clears one block of the top level, voxel by voxel.
void ObstacleMap::clear_block(const DepthView& view, const Body& body, const Cone& cone,
                              const Eigen::Vector3i& first) {
  Block* block = block_of(first);
  if (block == nullptr) return;
  const auto on_target = [&](const Eigen::Vector3d& p_C) { return body.contains(p_C, kBodyNoise); };
  each_cube(first, first.array() + OccupancyGrid::kBlock, 1, [&](const Eigen::Vector3i& at) {
    const Eigen::Vector3i in_block = at - first;
    std::uint8_t& flags = block->row(0, in_block.y(), in_block.z())[in_block.x()];
    if (!(flags & kAnyUnknown)) return;
    const Eigen::Vector3d p_C = centre(at.x(), at.y(), at.z());
    if (!cone.meets(p_C, resolution_)) return;
    if (view.hidden_only_by(p_C, 0.5 * resolution_, on_target)) flags = 0;
  });
}

}  // namespace quadrille

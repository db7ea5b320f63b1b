#pragma once

#include <algorithm>
#include <cmath>

#include "quadrille/grasping/occupancy.hpp"
#include "view/depth_view.hpp"

namespace quadrille::test {

/// What one voxel is by definition, pixel by pixel in long double: free if the centre's own pixel
/// and every pixel whose ray passes the voxel measured something beyond it, in the image or not.
/// Looks at all pixels between the projections of the corners.
class SeenSpace {
 public:
  explicit SeenSpace(const DepthView& view) : view_(view) {}

  bool free(const Eigen::Vector3d& centre_C, double half) const {
    Eigen::AlignedBox2d around;
    for (int n = 0; n < 8; ++n) {
      const Eigen::Vector3d corner(n & 1 ? half : -half, n & 2 ? half : -half,
                                   n & 4 ? half : -half);
      const Eigen::Vector3d p_V = view_.to_view(centre_C + corner);
      if (p_V.z() <= 1e-6) return false;
      around.extend(view_.pixel(p_V).cast<double>());
    }
    const Eigen::Vector3d p_V = view_.to_view(centre_C);
    const Eigen::Vector2i middle = view_.pixel(p_V);
    if (view_.depth(middle.x(), middle.y()) <= p_V.z()) return false;
    for (int v = static_cast<int>(around.min().y()) - 1; v <= around.max().y() + 1; ++v) {
      for (int u = static_cast<int>(around.min().x()) - 1; u <= around.max().x() + 1; ++u) {
        if (stops(u, v, centre_C, half)) return false;
      }
    }
    return true;
  }

 private:
  bool stops(int u, int v, const Eigen::Vector3d& centre_C, double half) const {
    const Eigen::Vector3d ray = view_.ray_C(u, v);
    long double enter = 0.0L, leave = 1e9L;
    for (int i = 0; i < 3; ++i) {
      const long double to = static_cast<long double>(centre_C[i]) - view_.p_CV()[i];
      const long double a = (to - half) / ray[i], b = (to + half) / ray[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave && view_.depth(u, v) <= leave;
  }

  const DepthView& view_;
};

/// Voxels of a grid that are wrong: free where some ray was stopped, or unknown where none was.
/// Those that a nanometre decides are left out and counted.
struct Wrong {
  long free = 0, unknown = 0, undecided = 0, right_free = 0;
};

inline Wrong compare(const OccupancyGrid& grid, const DepthView& view) {
  const SeenSpace space(view);
  Wrong wrong;
  const double half = 0.5 * grid.resolution();
  for (int k = 0; k < grid.size().z(); ++k) {
    for (int j = 0; j < grid.size().y(); ++j) {
      for (int i = 0; i < grid.size().x(); ++i) {
        const Voxel state = grid.at(i, j, k);
        if (state == Voxel::kOccupied) continue;
        const Eigen::Vector3d centre = grid.centre(i, j, k);
        const bool expected = space.free(centre, half + 1e-9);
        wrong.right_free += expected && state == Voxel::kFree;
        if (expected == (state == Voxel::kFree)) continue;
        if (space.free(centre, half - 1e-9) != expected) {
          ++wrong.undecided;
        } else {
          ++(expected ? wrong.unknown : wrong.free);
        }
      }
    }
  }
  return wrong;
}

}  // namespace quadrille::test

// Resamples a map of space in another frame.
#include <algorithm>
#include <array>

#include "quadrille/grasping/occupancy.hpp"
#include "space/each_cube.hpp"
#include "space/map_limits.hpp"

namespace quadrille {
namespace {

// Boxes that overlap a voxel by no more than this, in voxels, do not meet it; this absorbs
// rounding.
constexpr double kTouch = 1e-6;

/// Ranks the states by caution; the most cautious state comes first.
int caution(Voxel state) {
  constexpr std::array<int, 4> kRank = {1, 2, 3, 0};  // ranks of unknown, clear, free, occupied
  return kRank[static_cast<std::size_t>(state)];
}

}  // namespace

/// Returns the most cautious state of all voxels that a box meets; space outside the grid is
/// unknown.
Voxel OccupancyGrid::most_cautious(const Eigen::AlignedBox3d& box_C) const {
  const Eigen::Array3d corner = corner_.cast<double>();
  const Eigen::Array3d low = (box_C.min().array() / resolution_ - corner + kTouch).floor();
  const Eigen::Array3d high = (box_C.max().array() / resolution_ - corner - kTouch).floor();
  const Eigen::Vector3i from = low.max(0.0).cast<int>();
  const Eigen::Vector3i to = (high.min(size_.cast<double>().array() - 1.0) + 1.0).cast<int>();
  const bool inside = (low >= 0.0).all() && (high < size_.cast<double>().array()).all();
  Voxel state = inside ? Voxel::kFree : Voxel::kUnknown;
  each_cube(from, to, 1, [&](const Eigen::Vector3i& voxel) {
    const Voxel here = at(voxel.x(), voxel.y(), voxel.z());
    if (caution(here) < caution(state)) state = here;
  });
  return state;
}

OccupancyGrid OccupancyGrid::moved(const Eigen::Isometry3d& X_FC) const {
  if (size_.isZero()) return *this;
  const Eigen::AlignedBox3d here = bounds();
  const Eigen::Matrix3d R_FC = X_FC.linear();
  const Eigen::Vector3d reach_F = R_FC.cwiseAbs() * (0.5 * here.sizes());
  const Eigen::Vector3d centre_F = X_FC * here.center();
  const Eigen::AlignedBox3d there(centre_F - reach_F, centre_F + reach_F);
  OccupancyGrid grid(there, fit_resolution(there, resolution_));
  const Eigen::Isometry3d X_CF = X_FC.inverse();
  const Eigen::Vector3d half_C =
      0.5 * grid.resolution_ * R_FC.transpose().cwiseAbs() * Eigen::Vector3d::Ones();
  each_cube(Eigen::Vector3i::Zero(), grid.size_, 1, [&](const Eigen::Vector3i& at) {
    const Eigen::Vector3d p_C = X_CF * grid.centre(at.x(), at.y(), at.z());
    grid.states_[grid.index(at.x(), at.y(), at.z())] = most_cautious({p_C - half_C, p_C + half_C});
  });
  return grid;
}

}  // namespace quadrille

// Resamples a map of space in another frame.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "quadrille/grasping/occupancy.hpp"
#include "space/each_cube.hpp"
#include "space/evidence.hpp"
#include "space/map_limits.hpp"
#include "space/space_on_demand.hpp"

namespace quadrille {
namespace {

// Boxes that overlap a voxel by no more than this, in voxels, do not meet it; this absorbs
// rounding.
constexpr double kTouch = 1e-6;

/// The states in the order of their caution, the most cautious first.
constexpr std::array<Voxel, 4> kByCaution = {Voxel::kOccupied, Voxel::kUnknown, Voxel::kClear,
                                             Voxel::kFree};

constexpr std::uint8_t caution(Voxel state) {
  std::uint8_t rank = 0;
  while (kByCaution[rank] != state) ++rank;
  return rank;
}

/// Returns the greatest integer that is not above x, up to rounding by 2^-33, far below kTouch; |x|
/// must stay below 2^20, as places of voxels do.
int floor_of(double x) {
  constexpr int kShift = 1 << 20;
  return static_cast<int>(x + kShift) - kShift;
}

/// Knows which cubes of a grid have one state throughout. Most have, since space is unknown behind
/// things and outside the image, and free before them.
class UniformCubes {
 public:
  /// Edge of the cubes in voxels, of which grids have a whole number.
  static constexpr int kEdge = 8;
  static_assert(OccupancyGrid::kBlock % kEdge == 0);

  explicit UniformCubes(const OccupancyGrid& grid) : size_(grid.size().array() / kEdge) {
    states_.reserve(static_cast<std::size_t>(size_.prod()));
    const std::vector<Voxel>& states = grid.states();
    each_cube(Eigen::Vector3i::Zero(), grid.size(), kEdge, [&](const Eigen::Vector3i& low) {
      states_.push_back(state_of_cube(grid, states, low));
    });
  }

  /// Returns the state that all voxels from `low` to `high` share, if they lie in cubes that have
  /// one state; space outside the grid is unknown.
  std::optional<Voxel> state_between(const Eigen::Array3d& low, const Eigen::Array3d& high) const {
    Eigen::Array3i from;
    Eigen::Array3i last;
    for (int axis = 0; axis < 3; ++axis) {
      from[axis] = std::clamp(floor_of(low[axis] / kEdge), -1, size_[axis]);
      last[axis] = std::clamp(floor_of(high[axis] / kEdge), -1, size_[axis]);
    }
    const std::optional<Voxel> first = state(from);
    if (!first) return std::nullopt;
    for (int k = from[2]; k <= last[2]; ++k) {
      for (int j = from[1]; j <= last[1]; ++j) {
        for (int i = from[0]; i <= last[0]; ++i) {
          if (state({i, j, k}) != first) return std::nullopt;
        }
      }
    }
    return first;
  }

 private:
  static std::optional<Voxel> state_of_cube(const OccupancyGrid& grid,
                                            const std::vector<Voxel>& states,
                                            const Eigen::Vector3i& low) {
    const Voxel first = states[grid.index(low.x(), low.y(), low.z())];
    for (int k = low.z(); k < low.z() + kEdge; ++k) {
      for (int j = low.y(); j < low.y() + kEdge; ++j) {
        const Voxel* row = &states[grid.index(low.x(), j, k)];
        if (std::count(row, row + kEdge, first) != kEdge) return std::nullopt;
      }
    }
    return first;
  }

  std::optional<Voxel> state(const Eigen::Array3i& cube) const {
    if ((cube < 0).any() || (cube >= size_).any()) return Voxel::kUnknown;
    return states_[(static_cast<std::size_t>(cube[2]) * size_[1] + cube[1]) * size_[0] + cube[0]];
  }

  Eigen::Array3i size_;
  std::vector<std::optional<Voxel>> states_;
};

/// Finds the most cautious state in boxes of one size in a grid; space outside the grid is unknown.
///
/// Along each axis such a box meets n or n + 1 voxels, wherever it lies. So the minima over windows
/// of n × n × n voxels are computed once, and eight of them cover each box.
class CautiousBoxes {
 public:
  /// @param reach  half the size of the boxes along each axis [voxels]
  CautiousBoxes(const OccupancyGrid& grid, const Eigen::Array3d& reach)
      : reach_(reach - kTouch),
        window_((2.0 * reach_).floor().cast<int>() + 1),
        most_(grid.size().array()),
        size_(grid.size().array() + 2 * window_),
        ranks_(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], caution(Voxel::kUnknown)) {
    const std::vector<Voxel>& states = grid.states();
    for (int k = 0; k < most_[2]; ++k) {
      for (int j = 0; j < most_[1]; ++j) {
        const auto row = states.begin() + static_cast<std::ptrdiff_t>(grid.index(0, j, k));
        std::transform(row, row + most_[0], &ranks_[index({0, j, k})], caution);
      }
    }
    const std::array<std::size_t, 3> step = {1, static_cast<std::size_t>(size_[0]),
                                             static_cast<std::size_t>(size_[0]) * size_[1]};
    for (int axis = 0; axis < 3; ++axis) {
      for (int n = 1; n < window_[axis]; ++n) take_minima(step[axis]);
    }
  }

  /// @param centre  middle of the box, counted in voxels from the grid's corner
  Voxel state(const Eigen::Array3d& centre) const {
    Eigen::Array3i from;
    Eigen::Array3i last;
    for (int axis = 0; axis < 3; ++axis) {
      const int low = floor_of(centre[axis] - reach_[axis]);
      const int high = floor_of(centre[axis] + reach_[axis]) - window_[axis] + 1;
      from[axis] = std::clamp(low, -window_[axis], most_[axis]);
      last[axis] = std::clamp(high, -window_[axis], most_[axis]);
    }
    std::uint8_t rank = caution(Voxel::kFree);
    for (const int k : {from[2], last[2]}) {
      for (const int j : {from[1], last[1]}) {
        for (const int i : {from[0], last[0]}) rank = std::min(rank, ranks_[index({i, j, k})]);
      }
    }
    return kByCaution[rank];
  }

 private:
  /// Returns where a voxel of the grid, or one of the unknown ones around it, is kept.
  std::size_t index(const Eigen::Array3i& voxel) const {
    const Eigen::Array3i at = voxel + window_;
    return (static_cast<std::size_t>(at[2]) * size_[1] + at[1]) * size_[0] + at[0];
  }

  /// Makes each window longer by one voxel. At the upper border it then reaches around into the
  /// next row, where all is unknown too.
  void take_minima(std::size_t step) {
    for (std::size_t n = 0; n + step < ranks_.size(); ++n) {
      ranks_[n] = std::min(ranks_[n], ranks_[n + step]);
    }
  }

  Eigen::Array3d reach_;
  Eigen::Array3i window_;
  Eigen::Array3i most_, size_;
  std::vector<std::uint8_t> ranks_;
};

}  // namespace

OccupancyGrid OccupancyGrid::moved(const Eigen::Isometry3d& X_FC) const {
  if (size_.isZero()) return *this;
  if (!source_) return resampled(X_FC);
  OccupancyGrid open = *this;
  open.source_ = nullptr;
  open.states_ = states();
  std::replace(open.states_.begin(), open.states_.end(), Voxel::kOccupied, Voxel::kUnknown);
  OccupancyGrid grid = open.resampled(X_FC);
  source_->evidence().occupy(X_FC, &grid);
  return grid;
}

/// Takes the most cautious state of all voxels that a voxel overlaps.
OccupancyGrid OccupancyGrid::resampled(const Eigen::Isometry3d& X_FC) const {
  const Eigen::AlignedBox3d here = bounds();
  const Eigen::Matrix3d R_FC = X_FC.linear();
  const Eigen::Vector3d reach_F = R_FC.cwiseAbs() * (0.5 * here.sizes());
  const Eigen::Vector3d centre_F = X_FC * here.center();
  const Eigen::AlignedBox3d there(centre_F - reach_F, centre_F + reach_F);
  OccupancyGrid grid(there, fit_resolution(there, resolution_));
  const Eigen::Isometry3d X_CF = X_FC.inverse();
  const Eigen::Array3d reach =
      R_FC.transpose().cwiseAbs().rowwise().sum() * (0.5 * grid.resolution_ / resolution_);
  const Eigen::Array3d corner = corner_.cast<double>();
  /// The place of a point of F, counted in voxels from the corner of this grid.
  const auto place = [&](const Eigen::Vector3d& p_F) -> Eigen::Array3d {
    return (X_CF * p_F).array() / resolution_ - corner;
  };
  const UniformCubes cubes(*this);
  const CautiousBoxes boxes(*this, reach);
  constexpr int kEdge = UniformCubes::kEdge;
  each_cube(Eigen::Vector3i::Zero(), grid.size_, kEdge, [&](const Eigen::Vector3i& low) {
    const Eigen::Vector3i end = low.array() + kEdge;
    const Eigen::Array3d middle = place(0.5 * (grid.centre(low.x(), low.y(), low.z()) +
                                               grid.centre(end.x() - 1, end.y() - 1, end.z() - 1)));
    const auto common = cubes.state_between(middle - kEdge * reach, middle + kEdge * reach);
    if (common == Voxel::kUnknown) return;  // as all voxels are at first
    each_cube(low, end, 1, [&](const Eigen::Vector3i& at) {
      grid.states_[grid.index(at.x(), at.y(), at.z())] =
          common ? *common : boxes.state(place(grid.centre(at.x(), at.y(), at.z())));
    });
  });
  return grid;
}

}  // namespace quadrille

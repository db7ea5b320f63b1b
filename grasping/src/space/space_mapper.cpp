#include "space/space_mapper.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "base/rounding.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "quadrille/detector/vector_clones.hpp"
#include "space/each_cube.hpp"

namespace quadrille {

namespace {

// Number of points whose voxels are found at once.
constexpr std::size_t kPointsAtOnce = 64;

/// Scales coordinates and rounds them down to whole numbers.
/// @param most  limits these numbers; missing coordinates become −`most`. As a constant it would
///   keep the compiler from using vectors.
QUADRILLE_VECTOR_CLONES
void round_down(const float* values, std::size_t count, float scale, float most,
                int* __restrict numbers) {
  for (std::size_t n = 0; n < count; ++n) {
    float x = values[n] * scale;
    x = x > -most ? x : -most;
    x = x < most ? x : most;
    const int number = static_cast<int>(x);
    numbers[n] = number - static_cast<int>(x < static_cast<float>(number));
  }
}

}  // namespace

static_assert(static_cast<int>(Voxel::kUnknown) == 0, "zeroed memory holds unknown voxels");

SpaceMapper::SpaceMapper(const Eigen::AlignedBox3d& region, double resolution,
                         std::vector<Eigen::AlignedBox3d> boxes_C, int threads)
    : grid_(OccupancyGrid::without_states(region, resolution)),
      states_(grid_.size().cast<std::size_t>().prod()),
      occupied_(blocks()),
      boxes_C_(std::move(boxes_C)),
      threads_(threads) {}

OccupancyGrid SpaceMapper::take() && {
  grid_.states_.assign(states_.begin(), states_.end());
  return std::move(grid_);
}

void SpaceMapper::add(const PointCloud& cloud, const DepthView& view,
                      const std::vector<std::uint8_t>& left_out) {
  if (view.stray().size() != cloud.points.size() || left_out.size() != cloud.points.size()) {
    throw std::invalid_argument("occupancy: the view is not that of the cloud");
  }
  // Occupied voxels are marked first, so that they need not be tested for being free.
  mark_occupied(cloud, left_out);
  if (view.valid()) mark_free(view, std::vector<char>());
}

void SpaceMapper::add_points(const PointCloud& cloud, const std::vector<std::uint8_t>& left_out) {
  if (left_out.size() != cloud.points.size()) {
    throw std::invalid_argument("occupancy: the marks are not those of the cloud");
  }
  mark_occupied(cloud, left_out);
}

bool SpaceMapper::wanted(const Eigen::Vector3i& block) const {
  const double edge = kBlock * grid_.resolution();
  const Eigen::Vector3d low = (grid_.corner() + block).cast<double>() * grid_.resolution();
  const Eigen::AlignedBox3d box(low, low + Eigen::Vector3d::Constant(edge));
  return boxes_C_.empty() ||
         std::any_of(boxes_C_.begin(), boxes_C_.end(),
                     [&](const Eigen::AlignedBox3d& wanted) { return wanted.intersects(box); });
}

/// Returns the middle of a cube of voxels in the frame of the view.
Eigen::Vector3d SpaceMapper::middle_V(const DepthView& view, const Eigen::Vector3i& low,
                                      int edge) const {
  return view.to_view(((grid_.corner() + low).cast<double>().array() + 0.5 * edge) *
                      grid_.resolution());
}

void SpaceMapper::mark_free(const DepthView& view, const std::vector<char>& marked) {
  std::vector<Eigen::Vector3i> blocks;
  each_cube(Eigen::Vector3i::Zero(), grid_.size(), kBlock, [&](const Eigen::Vector3i& block) {
    const bool is_marked = !marked.empty() && marked[block_index(block)] != 0;
    if (!is_marked && wanted(block)) blocks.push_back(block);
  });
  // Blocks have no voxel in common.
  parallel_for(static_cast<int>(blocks.size()), threads_,
               [&](int n) { mark_free(view, blocks[n], kAllEighths); });
}

/// Works top-down: a block that the image shows at once to be free or hidden is not divided.
void SpaceMapper::mark_free(const DepthView& view, const Eigen::Vector3i& block, unsigned eighths) {
  constexpr int kHalf = kBlock / 2;
  if (is_known(block, kBlock)) return;
  const Eigen::Vector3d p_V = middle_V(view, block, kBlock);
  const Eigen::Vector3d reach = view.reach(0.5 * kBlock * grid_.resolution());
  const DepthRange range = view.range(p_V, reach);
  if (p_V.z() - reach.z() > range.max) return;
  if (p_V.z() + reach.z() >= range.min) return mark_eighths(view, block, kHalf, p_V, eighths);
  for (int n = 0; n < 8; ++n) {
    if (eighths >> n & 1u) fill_free(block + kHalf * eighth_of_cube(n), kHalf);
  }
}

/// True if each voxel of a cube is free or occupied, as after other views.
bool SpaceMapper::is_known(const Eigen::Vector3i& low, int edge) const {
  for (int k = low.z(); k < low.z() + edge; ++k) {
    for (int j = low.y(); j < low.y() + edge; ++j) {
      const Voxel* row = &voxel(low.x(), j, k);
      if (*std::min_element(row, row + edge) < Voxel::kFree) return false;
    }
  }
  return true;
}

/// Marks eighths, of a given edge, of the cube around the point p_V of the view.
void SpaceMapper::mark_eighths(const DepthView& view, const Eigen::Vector3i& low, int edge,
                               const Eigen::Vector3d& p_V, unsigned eighths) {
  const double half = 0.5 * edge * grid_.resolution();
  const Eigen::Matrix3d axes_V = view.axes() * half;
  DepthView::EightPoints eight;
  for (unsigned n = 0; n < 8; ++n) {
    const Eigen::Vector3d middle_V = p_V + axes_V * cube_corner(n);
    eight.x[n] = static_cast<float>(middle_V.x());
    eight.y[n] = static_cast<float>(middle_V.y());
    eight.z[n] = static_cast<float>(middle_V.z());
  }
  const Eigen::Vector3d reach = view.reach(half);
  const std::array<DepthRange, 8> ranges = view.ranges(eight, reach);
  for (int n = 0; n < 8; ++n) {
    if (!(eighths >> n & 1u)) continue;
    const Eigen::Vector3i at = low + edge * eighth_of_cube(n);
    // Depths that are equal to within the rounding of floats are compared exactly, by sees_past().
    const double z = eight.z[n], slack = reach.z() + kFloatRounding * (1.0 + z);
    if (z - slack > ranges[n].max) continue;
    const bool free = z + slack < ranges[n].min;
    if (edge == 1) {
      Voxel& state = voxel(at.x(), at.y(), at.z());
      if (state >= Voxel::kFree) continue;
      if (free || view.sees_past(grid_.centre(at.x(), at.y(), at.z()), half)) state = Voxel::kFree;
    } else if (free) {
      fill_free(at, edge);
    } else if (!is_known(at, edge)) {
      mark_eighths(view, at, edge / 2, p_V + axes_V * cube_corner(static_cast<unsigned>(n)),
                   kAllEighths);
    }
  }
}

void SpaceMapper::mark_occupied(const PointCloud& cloud,
                                const std::vector<std::uint8_t>& left_out) {
  const float scale = static_cast<float>(1.0 / grid_.resolution());
  // No grid reaches so far.
  constexpr float kBeyond = static_cast<float>(2.0 * OccupancyGrid::kMaxCoordinate);
  const Eigen::Vector3i corner = grid_.corner(), size = grid_.size();
  // Unlike vectors, these do not check each access.
  const Eigen::Vector3f* points = cloud.points.data();
  const std::uint8_t* left = left_out.data();
  Voxel* states = states_.data();
  char* occupied = occupied_.data();
  std::array<int, 3 * kPointsAtOnce> numbers;
  for (std::size_t first = 0; first < cloud.points.size(); first += kPointsAtOnce) {
    const std::size_t count = std::min(kPointsAtOnce, cloud.points.size() - first);
    round_down(points[first].data(), 3 * count, scale, kBeyond, numbers.data());
    const int* number = numbers.data();
    for (std::size_t n = first; n < first + count; ++n, number += 3) {
      const int i = number[0] - corner.x(), j = number[1] - corner.y(), k = number[2] - corner.z();
      // A negative number becomes a large one without its sign, so one comparison finds both.
      const auto beyond = [](int x, int count) {
        return static_cast<unsigned>(x) >= static_cast<unsigned>(count);
      };
      if (beyond(i, size.x()) || beyond(j, size.y()) || beyond(k, size.z())) continue;
      if (left[n]) continue;
      // No grid has so many voxels that their number needs more bits.
      Voxel& state = states[(k * size.y() + j) * size.x() + i];
      // Points that follow each other mostly lie in the same voxel.
      if (state == Voxel::kOccupied) continue;
      state = Voxel::kOccupied;
      const auto block = [](int x) { return static_cast<std::size_t>(x) / kBlock; };
      occupied[(block(k) * block(size.y()) + block(j)) * block(size.x()) + block(i)] = 1;
    }
  }
}

void SpaceMapper::replace(Voxel old_state, Voxel new_state) {
  std::replace(states_.begin(), states_.end(), old_state, new_state);
}

std::vector<Eigen::Vector3i> SpaceMapper::occupied_blocks() const {
  std::vector<Eigen::Vector3i> blocks;
  each_cube(Eigen::Vector3i::Zero(), grid_.size(), kBlock, [&](const Eigen::Vector3i& block) {
    if (occupied_[block_index(block)] != 0) blocks.push_back(block);
  });
  return blocks;
}

/// Marks the voxels as free, except those that another view found occupied.
void SpaceMapper::fill_free(const Eigen::Vector3i& low, int edge) {
  for (int k = low.z(); k < low.z() + edge; ++k) {
    for (int j = low.y(); j < low.y() + edge; ++j) {
      Voxel* row = &voxel(low.x(), j, k);
      for (int i = 0; i < edge; ++i) row[i] = std::max(row[i], Voxel::kFree);
    }
  }
}

}  // namespace quadrille

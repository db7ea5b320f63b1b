#include "contacts/finger_runs.hpp"

#include <algorithm>
#include <limits>

#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {
namespace {

constexpr std::size_t kDepthLanes = FingerRuns::kMaxDepths;
constexpr float kFarAway = std::numeric_limits<float>::infinity();
using DepthLanes __attribute__((vector_size(kDepthLanes * sizeof(float)), may_alias)) = float;
using DepthMasks __attribute__((vector_size(kDepthLanes * sizeof(float)), may_alias)) = int;
using DepthHalves __attribute__((vector_size(kDepthLanes * sizeof(float)), may_alias)) = long long;

/// Sets a value for each depth; depths that are not used get −∞.
inline __attribute__((always_inline)) void fill_lanes(std::span<const float> values,
                                                      DepthLanes& lanes) {
  for (std::size_t n = 0; n < kDepthLanes; ++n)
    lanes[n] = n < values.size() ? values[n] : -kFarAway;
}

static_assert(sizeof(DepthMasks) == 4 * sizeof(long long));

inline __attribute__((always_inline)) bool any(const DepthMasks& masks) {
  const DepthHalves halves = reinterpret_cast<DepthHalves>(masks);
  return ((halves[0] | halves[1]) | (halves[2] | halves[3])) != 0;
}

}  // namespace

QUADRILLE_VECTOR_CLONES
void FingerRuns::find(std::span<const InSlice> points, std::span<const float> tips,
                      std::span<const float> roots) {
  for (std::vector<Run>& runs : runs_) runs.clear();
  DepthLanes tip, root, last_y;
  fill_lanes(tips, tip), fill_lanes(roots, root);
  // The first point lies infinitely far from a previous one, and so starts a run.
  fill_lanes({}, last_y);
  std::array<std::size_t, kDepthLanes> first{};
  DepthMasks last = {}, count = {};
  // Unlike spans, this does not check each access.
  const InSlice* point = points.data();
  const int size = static_cast<int>(points.size());
  for (int here = 0; here < size; ++here, ++point) {
    const DepthMasks in = (point->z < tip) & (point->z > root);
    const DepthMasks starts = in & (point->y - last_y > gap_);
    if (any(starts)) {
      for (std::size_t n = 0; n < kDepthLanes; ++n) {
        if (starts[n] == 0) continue;
        if (count[n] > 0) {
          runs_[n].push_back(
              {first[n], static_cast<std::size_t>(last[n]), static_cast<std::size_t>(count[n])});
        }
        first[n] = static_cast<std::size_t>(here);
        count[n] = 0;
      }
    }
    const DepthLanes y = point->y - DepthLanes{};
    last_y = reinterpret_cast<DepthLanes>((in & reinterpret_cast<const DepthMasks&>(y)) |
                                          (~in & reinterpret_cast<const DepthMasks&>(last_y)));
    last = (in & here) | (~in & last);
    count -= in;
  }
  for (std::size_t n = 0; n < kDepthLanes; ++n) {
    if (count[n] == 0) continue;
    runs_[n].push_back(
        {first[n], static_cast<std::size_t>(last[n]), static_cast<std::size_t>(count[n])});
  }
}

}  // namespace quadrille

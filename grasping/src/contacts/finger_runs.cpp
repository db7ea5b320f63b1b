#include "contacts/finger_runs.hpp"

#include <algorithm>
#include <limits>

#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {
namespace {

constexpr std::size_t kLanes = FingerRuns::kMaxDepths;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
using Lanes __attribute__((vector_size(kLanes * sizeof(float)), may_alias)) = float;
using Masks __attribute__((vector_size(kLanes * sizeof(float)), may_alias)) = int;
using Halves __attribute__((vector_size(kLanes * sizeof(float)), may_alias)) = long long;

/// Sets a value for each depth; depths that are not used get −∞.
inline __attribute__((always_inline)) void fill(std::span<const float> values, Lanes& lanes) {
  for (std::size_t n = 0; n < kLanes; ++n) lanes[n] = n < values.size() ? values[n] : -kInfinity;
}

inline __attribute__((always_inline)) bool any(const Masks& masks) {
  const Halves halves = reinterpret_cast<Halves>(masks);
  return ((halves[0] | halves[1]) | (halves[2] | halves[3])) != 0;
}

}  // namespace

QUADRILLE_VECTOR_CLONES
void FingerRuns::find(std::span<const InSlice> points, std::span<const float> tips,
                      std::span<const float> roots) {
  for (std::vector<Run>& runs : runs_) runs.clear();
  Lanes tip, root, last_y;
  fill(tips, tip), fill(roots, root);
  // The first point lies infinitely far from a previous one, and so starts a run.
  fill({}, last_y);
  std::array<std::size_t, kLanes> first{};
  Masks last = {}, count = {};
  // Unlike spans, this does not check each access.
  const InSlice* point = points.data();
  const int size = static_cast<int>(points.size());
  for (int here = 0; here < size; ++here, ++point) {
    const Masks in = (point->z < tip) & (point->z > root);
    const Masks starts = in & (point->y - last_y > gap_);
    if (any(starts)) {
      for (std::size_t n = 0; n < kLanes; ++n) {
        if (starts[n] == 0) continue;
        if (count[n] > 0) {
          runs_[n].push_back(
              {first[n], static_cast<std::size_t>(last[n]), static_cast<std::size_t>(count[n])});
        }
        first[n] = static_cast<std::size_t>(here);
        count[n] = 0;
      }
    }
    const Lanes y = point->y - Lanes{};
    last_y = reinterpret_cast<Lanes>((in & reinterpret_cast<const Masks&>(y)) |
                                     (~in & reinterpret_cast<const Masks&>(last_y)));
    last = (in & here) | (~in & last);
    count -= in;
  }
  for (std::size_t n = 0; n < kLanes; ++n) {
    if (count[n] == 0) continue;
    runs_[n].push_back(
        {first[n], static_cast<std::size_t>(last[n]), static_cast<std::size_t>(count[n])});
  }
}

}  // namespace quadrille

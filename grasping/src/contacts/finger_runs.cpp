#include "contacts/finger_runs.hpp"

#include <algorithm>
#include <limits>

#include "base/lanes.hpp"

namespace quadrille {
namespace {

static_assert(FingerRuns::kMaxDepths == kFloatLanes);
constexpr float kFarAway = std::numeric_limits<float>::infinity();
// Number of points after which the depths are asked whether a run has started.
constexpr std::size_t kRunBlock = 8;
using FloatHalves __attribute__((vector_size(kFloatLanes * sizeof(float)), may_alias)) = long long;

/// Sets a value for each depth; depths that are not used get −∞.
QUADRILLE_INTO_CLONES void fill_lanes(std::span<const float> values, FloatLanes& lanes) {
  for (std::size_t n = 0; n < FingerRuns::kMaxDepths; ++n)
    lanes[n] = n < values.size() ? values[n] : -kFarAway;
}

static_assert(sizeof(FloatMasks) == 4 * sizeof(long long));

QUADRILLE_INTO_CLONES bool any(const FloatMasks& masks) {
  const FloatHalves halves = reinterpret_cast<FloatHalves>(masks);
  return ((halves[0] | halves[1]) | (halves[2] | halves[3])) != 0;
}

/// The points of a slice.
struct SlicePoints {
  const float *y_of, *z_of;
  const std::uint32_t* places;

  float y(std::size_t k) const { return y_of[places[k]]; }
  float z(std::size_t k) const { return z_of[places[k]]; }
  bool reached(std::size_t k, float tip, float root) const { return z(k) < tip && z(k) > root; }
};

/// Adds the runs of one depth that start among some points, and ends those before them.
struct RunStarter {
  const SlicePoints& points;
  float tip, root, gap;
  std::vector<Run>& runs;

  /// @param last  the last point before them that is reached, if there is a run already
  /// @param last_y  where it lies; infinitely far away if there is no run
  void add(std::size_t first, std::size_t end, std::size_t last, float last_y) {
    for (std::size_t k = first; k < end; ++k) {
      if (!points.reached(k, tip, root)) continue;
      if (points.y(k) - last_y > gap) {
        if (!runs.empty()) runs.back().last = last;
        runs.push_back({k, k});
      }
      last = k, last_y = points.y(k);
    }
  }
};

}  // namespace

QUADRILLE_VECTOR_CLONES
void FingerRuns::find(const SortedPoints& sorted, std::span<const std::uint32_t> places,
                      std::span<const float> tips, std::span<const float> roots) {
  for (std::vector<Run>& runs : runs_) runs.clear();
  const SlicePoints points{sorted.y, sorted.z, places.data()};
  const float gap = gap_;
  FloatLanes tip, root, last_y;
  fill_lanes(tips, tip), fill_lanes(roots, root);
  // The first point lies infinitely far from a previous one, and so starts a run.
  fill_lanes({}, last_y);
  FloatMasks last = {};
  for (std::size_t first = 0; first < places.size(); first += kRunBlock) {
    const std::size_t end = std::min(first + kRunBlock, places.size());
    const FloatLanes y_before = last_y;
    const FloatMasks before = last;
    FloatMasks started = {}, here = static_cast<int>(first) - FloatMasks{};
    for (std::size_t k = first; k < end; ++k) {
      const FloatMasks in = (points.z(k) < tip) & (points.z(k) > root);
      const FloatLanes y = points.y(k) - FloatLanes{};
      started |= in & (y - last_y > gap);
      replace_in(in, y, last_y), replace_in(in, here, last);
      here += 1;
    }
    if (!any(started)) continue;
    for (std::size_t n = 0; n < tips.size(); ++n) {
      if (started[n] == 0) continue;
      RunStarter{points, tips[n], roots[n], gap, runs_[n]}.add(
          first, end, static_cast<std::size_t>(before[n]), y_before[n]);
    }
  }
  for (std::size_t n = 0; n < tips.size(); ++n) {
    if (!runs_[n].empty()) runs_[n].back().last = static_cast<std::size_t>(last[n]);
  }
}

}  // namespace quadrille

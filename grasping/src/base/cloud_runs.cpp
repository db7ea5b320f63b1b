#include "base/cloud_runs.hpp"

#include <cstring>
#include <limits>

#include "base/lanes.hpp"

namespace quadrille {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Finds the bounds of the coordinates of points. Missing ones are left out, since they compare as
/// false.
/// @param values  x, y, z, x, y, z …, of which there are `count`
/// @param low     receives the bounds of x, y and z, as `high` does
QUADRILLE_VECTOR_CLONES
void find_bounds(const float* values, std::size_t count, float* low, float* high) {
  // Eight points at once, whose coordinates fill three registers.
  constexpr std::size_t kRegisters = 3, kAtOnce = kRegisters * kFloatLanes;
  FloatLanes least[kRegisters], most[kRegisters];
  for (std::size_t r = 0; r < kRegisters; ++r) {
    least[r] = FloatLanes{} + kInfinity;
    most[r] = -least[r];
  }
  std::size_t first = 0;
  for (; first + kAtOnce <= count; first += kAtOnce) {
    for (std::size_t r = 0; r < kRegisters; ++r) {
      FloatLanes x;
      load(values + first + r * kFloatLanes, x);
      replace_in(x < least[r], x, least[r]);
      replace_in(x > most[r], x, most[r]);
    }
  }
  float lows[kAtOnce], highs[kAtOnce];
  std::memcpy(lows, least, sizeof(lows));
  std::memcpy(highs, most, sizeof(highs));
  const auto extend = [&](const float* least_of, const float* most_of, std::size_t n) {
    for (std::size_t k = 0; k + 3 <= n; k += 3) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = least_of[k + axis] < low[axis] ? least_of[k + axis] : low[axis];
        high[axis] = most_of[k + axis] > high[axis] ? most_of[k + axis] : high[axis];
      }
    }
  };
  extend(lows, highs, kAtOnce);
  extend(values + first, values + first, count - first);
}

}  // namespace

CloudRuns::CloudRuns(std::span<const Eigen::Vector3f> points_C) : points_C_(points_C) {
  runs_.reserve(points_C.size() / kRun + 1);
  for (std::size_t first = 0; first < points_C.size(); first += kRun) {
    Eigen::Array3f low = Eigen::Array3f::Constant(kInfinity), high = -low;
    const std::size_t count = std::min(kRun, points_C.size() - first);
    find_bounds(points_C[first].data(), 3 * count, low.data(), high.data());
    runs_.push_back({low, high});
  }
}

}  // namespace quadrille

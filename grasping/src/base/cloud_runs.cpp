#include "base/cloud_runs.hpp"

#include <limits>

namespace quadrille {

CloudRuns::CloudRuns(std::span<const Eigen::Vector3f> points_C) : points_C_(points_C) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  runs_.reserve(points_C.size() / kRun + 1);
  for (std::size_t first = 0; first < points_C.size(); first += kRun) {
    Eigen::Array3f low = Eigen::Array3f::Constant(kInfinity), high = -low;
    for (const Eigen::Vector3f& p_C :
         points_C.subspan(first).first(std::min(kRun, points_C.size() - first))) {
      // Missing coordinates are left out, since they compare as false.
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = p_C[axis] < low[axis] ? p_C[axis] : low[axis];
        high[axis] = p_C[axis] > high[axis] ? p_C[axis] : high[axis];
      }
    }
    runs_.push_back({low, high});
  }
}

}  // namespace quadrille

#include "cloud/some_points.hpp"

#include "base/quantile.hpp"

namespace quadrille {

std::vector<Eigen::Vector3d> some_of(std::span<const Eigen::Vector3f> points) {
  std::vector<Eigen::Vector3d> some;
  const std::size_t stride = step_over(points.size());
  for (std::size_t i = 0; i < points.size(); i += stride) {
    if (points[i].allFinite()) some.push_back(points[i].cast<double>());
  }
  return some;
}

Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& some) {
  Eigen::Vector3d middle;
  std::vector<double> values(some.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < some.size(); ++k) values[k] = some[k][axis];
    middle[axis] = quantile(values, 0.5);
  }
  return middle;
}

}  // namespace quadrille

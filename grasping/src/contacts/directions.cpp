#include "contacts/directions.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace quadrille {

std::vector<Eigen::Vector3d> fan(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                                 int count, double turn) {
  std::vector<Eigen::Vector3d> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double t = turn * k / count;
    directions.emplace_back(std::cos(t) * first + std::sin(t) * second);
  }
  return directions;
}

std::vector<Eigen::Vector3d> half_sphere(int count) {
  std::vector<Eigen::Vector3d> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double z = (i + 0.5) / count, r = std::sqrt(1.0 - z * z);
    const double t = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    directions.emplace_back(r * std::cos(t), r * std::sin(t), z);
  }
  return directions;
}

std::vector<Eigen::Vector3d> level_directions(const Eigen::Vector3d& up, int count) {
  if (up.isZero()) return {};
  const Eigen::Vector3d level = up.unitOrthogonal();
  return fan(level, up.cross(level), count, std::numbers::pi);
}

}  // namespace quadrille

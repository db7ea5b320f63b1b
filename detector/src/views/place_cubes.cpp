#include "views/place_cubes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace quadrille {
namespace {

// Coordinates of cubes have 21 bits, and places beyond share the outermost cubes.
constexpr double kMostCubes = (1 << 20) - 1;

std::uint64_t cube_at(std::int64_t x, std::int64_t y, std::int64_t z) {
  return static_cast<std::uint64_t>(x) | static_cast<std::uint64_t>(y) << 21 |
         static_cast<std::uint64_t>(z) << 42;
}

}  // namespace

/// Number of the cube along an axis; not negative.
std::int64_t PlaceCubes::coordinate(double x) const {
  return static_cast<std::int64_t>(std::clamp(std::floor(x / edge_), -kMostCubes, kMostCubes) +
                                   kMostCubes);
}

PlaceCubes::PlaceCubes(std::span<const Eigen::Vector3f> places, float edge)
    : places_(places), edge_(edge) {
  std::vector<std::pair<std::uint64_t, int>> sorted;
  sorted.reserve(places.size());
  for (const Eigen::Vector3f& p : places) {
    sorted.emplace_back(cube_at(coordinate(p.x()), coordinate(p.y()), coordinate(p.z())),
                        static_cast<int>(sorted.size()));
  }
  std::sort(sorted.begin(), sorted.end());
  order_.reserve(sorted.size());
  for (const auto& [cube, k] : sorted) {
    if (cubes_.empty() || cubes_.back() != cube) {
      cubes_.push_back(cube);
      first_.push_back(static_cast<int>(order_.size()));
    }
    order_.push_back(k);
  }
  first_.push_back(static_cast<int>(order_.size()));
}

std::vector<int> PlaceCubes::near(const Eigen::Vector3f& p, float reach) const {
  const double r = reach;
  const std::int64_t x0 = coordinate(p.x() - r), x1 = coordinate(p.x() + r);
  const std::int64_t y0 = coordinate(p.y() - r), y1 = coordinate(p.y() + r);
  const std::int64_t z0 = coordinate(p.z() - r), z1 = coordinate(p.z() + r);
  std::vector<int> found;
  for (std::int64_t z = z0; z <= z1; ++z) {
    for (std::int64_t y = y0; y <= y1; ++y) {
      const auto begin = std::lower_bound(cubes_.begin(), cubes_.end(), cube_at(x0, y, z));
      auto end = begin;
      while (end != cubes_.end() && *end <= cube_at(x1, y, z)) ++end;
      const int last = first_[end - cubes_.begin()];
      for (int n = first_[begin - cubes_.begin()]; n < last; ++n) {
        const int k = order_[n];
        if ((places_[k] - p).squaredNorm() < reach * reach) found.push_back(k);
      }
    }
  }
  return found;
}

}  // namespace quadrille

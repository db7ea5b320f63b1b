#include "planes/plane_claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {
namespace {

/// For each cell of the coarsest level, the planes that have samples in it or in a neighbour.
std::vector<std::vector<int>> planes_near(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                          const std::vector<PlaneRegion>& planes) {
  std::vector<std::vector<int>> near(static_cast<std::size_t>(pyramid.size(kLevels - 1)));
  const auto add = [&](int sample, int plane) {
    std::vector<int>& list = near[coarse.source[sample]];
    if (list.empty() || list.back() != plane) list.push_back(plane);
  };
  for (std::size_t k = 0; k < planes.size(); ++k) {
    for (const int s : planes[k].samples) {
      add(s, static_cast<int>(k));
      for (const int j : coarse.neighbours_of(s)) add(j, static_cast<int>(k));
    }
  }
  return near;
}

}  // namespace

std::vector<int> planes_of_cells(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                 const std::vector<PlaneRegion>& planes, double sigmas) {
  const std::vector<std::vector<int>> near = planes_near(pyramid, coarse, planes);
  const int size = pyramid.size(0);
  static_assert(kLevels == 3);
  const std::array<const int*, kLevels - 1> parents = {pyramid.parents(0).data(),
                                                       pyramid.parents(1).data()};
  std::vector<int> plane_of_cell(static_cast<std::size_t>(size), -1);
  for (int c = 0; c < size; ++c) {
    int above = c;
    for (const int* parent : parents) above = parent[above];
    if (near[above].empty() || pyramid.count(c) == 0) continue;
    const Eigen::Vector4d x = pyramid.mean(c).cast<double>().homogeneous();
    double nearest = sigmas * pyramid.sigma(c);
    for (const int k : near[above]) {
      const double distance = std::abs(planes[k].plane.dot(x));
      if (!(distance < nearest)) continue;
      nearest = distance;
      plane_of_cell[c] = k;
    }
  }
  return plane_of_cell;
}

Mask cells_off_planes(const std::vector<int>& plane_of_cell) {
  Mask keep;
  keep.reserve(plane_of_cell.size());
  for (const int plane : plane_of_cell) keep.push_back(plane < 0);
  return keep;
}

}  // namespace quadrille

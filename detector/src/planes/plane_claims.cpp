#include "planes/plane_claims.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/buckets.hpp"
#include "quadrille/detector/parallel_for.hpp"

namespace quadrille {
namespace {

/// The planes that have samples in each cell of the coarsest level or in a neighbour.
class PlanesNear {
 public:
  PlanesNear(const CellPyramid& pyramid, const SurfaceSamples& coarse,
             const std::vector<PlaneRegion>& planes) {
    const int size = pyramid.size(kLevels - 1);
    std::vector<int> cell, last(static_cast<std::size_t>(size), -1);
    const auto add = [&](int sample, int plane) {
      const int c = coarse.source[sample];
      if (std::exchange(last[c], plane) == plane) return;
      cell.push_back(c);
      plane_.push_back(plane);
    };
    for (std::size_t k = 0; k < planes.size(); ++k) {
      for (const int s : planes[k].samples) {
        add(s, static_cast<int>(k));
        for (const int j : coarse.neighbours_of(s)) add(j, static_cast<int>(k));
      }
    }
    in_cell_ = sort_into_buckets(cell, size);
  }

  /// Calls visit(plane) for each plane near a cell, in ascending order.
  template <class Visit>
  void visit(int cell, Visit&& visit) const {
    const int* const first = in_cell_.first.data() + cell;
    for (int k = first[0]; k < first[1]; ++k) visit(plane_.data()[in_cell_.list.data()[k]]);
  }
  bool any(int cell) const {
    const int* const first = in_cell_.first.data() + cell;
    return first[0] < first[1];
  }

 private:
  std::vector<int> plane_;
  Buckets in_cell_;
};

}  // namespace

std::vector<int> planes_of_cells(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                 const std::vector<PlaneRegion>& planes, double sigmas,
                                 int threads) {
  const PlanesNear near(pyramid, coarse, planes);
  const int size = pyramid.size(0);
  static_assert(kLevels == 3);
  const int *const parent = pyramid.parents(0).data(), *const above = pyramid.parents(1).data();
  std::vector<int> plane_of_cell(static_cast<std::size_t>(size), -1);
  const auto find = [&](int begin, int end) {
    for (int c = begin; c < end; ++c) {
      const int coarsest = above[parent[c]];
      if (!near.any(coarsest) || pyramid.count(c) == 0) continue;
      const Eigen::Vector4d x = pyramid.mean(c).cast<double>().homogeneous();
      const auto [least, most] = pyramid.sigma_bounds(c);
      double nearest = sigmas * most;
      int found = -1;
      near.visit(coarsest, [&](int k) {
        const double distance = std::abs(planes.data()[k].plane.dot(x));
        if (!(distance < nearest)) return;
        nearest = distance;
        found = k;
      });
      // Only what lies between the bounds needs the noise itself.
      if (found < 0 || (!(nearest < sigmas * least) && !(nearest < sigmas * pyramid.sigma(c)))) {
        continue;
      }
      plane_of_cell.data()[c] = found;
    }
  };
  // Planes are seldom spread evenly over the image, so each thread has several parts of it.
  constexpr int kPartsPerThread = 4;
  const int parts = threads > 1 ? kPartsPerThread * threads : 1, step = size / parts + 1;
  parallel_for(parts, threads,
               [&](int k) { find(std::min(size, k * step), std::min(size, (k + 1) * step)); });
  return plane_of_cell;
}

Mask cells_off_planes(const std::vector<int>& plane_of_cell) {
  Mask keep;
  keep.resize(plane_of_cell.size());
  std::transform(plane_of_cell.begin(), plane_of_cell.end(), keep.begin(),
                 [](int plane) { return static_cast<char>(plane < 0); });
  return keep;
}

}  // namespace quadrille

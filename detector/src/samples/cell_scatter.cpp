#include "samples/cell_scatter.hpp"

#include <cstddef>

namespace quadrille {
namespace {

// Approximate number of points that are looked at: about one for each cell of a surface.
constexpr std::size_t kPoints = 50'000;

}  // namespace

std::vector<Eigen::Matrix3f> scatter_in_cells(const CloudView& cloud, const CellPyramid& pyramid,
                                              std::span<const int> owner) {
  std::vector<Eigen::Matrix3f> scatter(owner.size(), Eigen::Matrix3f::Zero());
  // An odd step meets other columns in each row of most images, whose width is even.
  const std::size_t step = cloud.points.size() / kPoints | 1;
  for (std::size_t k = 0; k < cloud.points.size(); k += step) {
    const int cell = pyramid.cell_of(cloud.points[k]);
    if (cell < 0 || owner[cell] < 0) continue;
    const Eigen::Vector3f x = cloud.points[k] - pyramid.mean(cell);
    const float weight = static_cast<float>(step) / static_cast<float>(pyramid.count(cell));
    scatter[cell] += weight * x * x.transpose();
  }
  return scatter;
}

}  // namespace quadrille

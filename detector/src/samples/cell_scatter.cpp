#include "samples/cell_scatter.hpp"

#include <cstddef>

namespace quadrille {
namespace {

// Approximate number of points that are looked at: about one for each cell of a surface.
constexpr std::size_t kPoints = 50'000;

}  // namespace

void scatter_in_cells(const CloudView& cloud, const CellPyramid& pyramid,
                      std::span<const int> number, std::vector<Eigen::Matrix3f>* scatter) {
  // An odd step meets other columns in each row of most images, whose width is even.
  const std::size_t step = cloud.points.size() / kPoints | 1;
  pyramid.visit_points(cloud, step, number, [&](std::size_t k, int cell) {
    const Eigen::Vector3f x = cloud.points[k] - pyramid.mean(cell);
    const float weight = static_cast<float>(step) / static_cast<float>(pyramid.count(cell));
    (*scatter)[number[cell]] += weight * x * x.transpose();
  });
}

}  // namespace quadrille

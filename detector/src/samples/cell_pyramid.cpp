#include "samples/cell_pyramid.hpp"

#include <Eigen/Geometry>

namespace quadrille {
namespace {

/// Diagonal of the bounding box of the finite points [m].
double diameter_of(const CloudView& cloud) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (p.allFinite()) box.extend(p);
  }
  return box.isEmpty() ? 0.0 : static_cast<double>(box.diagonal().norm());
}

}  // namespace

void CellPyramid::visit_points(const CloudView& cloud, std::size_t step, std::span<const int> owner,
                               const VisitPoint& visit) const {
  for (std::size_t k = 0; k < cloud.points.size(); k += step) {
    const int cell = cell_of(cloud.points[k]);
    if (cell >= 0 && owner[cell] >= 0) visit(k, cell);
  }
}

std::unique_ptr<CellPyramid> make_pyramid(const CloudView& cloud, const SamplingOptions& given) {
  SamplingOptions options = given;
  if (options.relative_cell > 0.0) options.cell = options.relative_cell * diameter_of(cloud);
  if (auto pyramid = make_depth_pyramid(cloud, options)) return pyramid;
  return make_voxel_pyramid(cloud, options);
}

}  // namespace quadrille

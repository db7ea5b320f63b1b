#include "space/evidence.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "quadrille/detector/near_shape.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "space/space_mapper.hpp"

namespace quadrille {
namespace {

/// The bounds of a grid without the outer halves of its outermost voxels, so that a grid made for
/// this region is not a block larger.
Eigen::AlignedBox3d region_of(const OccupancyGrid& grid) {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * grid.resolution());
  return {grid.bounds().min() + half, grid.bounds().max() - half};
}

}  // namespace

void OccupancyGrid::Evidence::occupy(const Eigen::Isometry3d& X_FC, OccupancyGrid* grid) const {
  PointCloud cloud;
  for (const std::vector<Eigen::Vector3f>* points : {points_C.get(), &beside_C}) {
    if (points == nullptr) continue;
    for (const Eigen::Vector3f& p_C : *points) {
      cloud.points.emplace_back((X_FC * p_C.cast<double>()).cast<float>());
    }
  }
  SpaceMapper mapper(region_of(*grid), grid->resolution());
  mapper.add_points(cloud, std::vector<std::uint8_t>(cloud.points.size(), 0));
  if (map.tree) mapper.add({map.tree, X_FC * map.X_CM});
  const RobotShapes there = quadrille::moved(robot, X_FC);
  for (const SolidShape& shape : there.shapes) {
    mapper.free_within(NearShape(shape, there.padding));
  }
  const OccupancyGrid made = std::move(mapper).take();
  if (made.size() != grid->size() || made.corner() != grid->corner()) {
    throw std::logic_error("a grid made again has other voxels");
  }
  for (std::size_t n = 0; n < made.states_.size(); ++n) {
    if (made.states_[n] == Voxel::kOccupied) grid->states_[n] = Voxel::kOccupied;
  }
}

}  // namespace quadrille

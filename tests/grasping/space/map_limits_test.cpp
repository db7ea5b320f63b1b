#include "space/map_limits.hpp"

#include <limits>

#include "quadrille/grasping/occupancy.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

Eigen::AlignedBox3d cube(const Eigen::Vector3d& centre, double edge) {
  return {centre.array() - 0.5 * edge, centre.array() + 0.5 * edge};
}

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

}  // namespace

TEST_CASE("a grid has as many voxels as are counted before it is made", "[space][limits]") {
  const double resolution = GENERATE(0.005, 0.0173, 0.3);
  const Eigen::AlignedBox3d region(Eigen::Vector3d(-0.31, 0.02, 0.4),
                                   Eigen::Vector3d(0.7, 0.05, 1.9));
  CHECK(static_cast<double>(OccupancyGrid(region, resolution).states().size()) ==
        count_voxels(region, resolution));
}

TEST_CASE("a region of any shape is mapped within the bound, and no coarser than it must",
          "[space][limits]") {
  const Eigen::Vector3d size = GENERATE(Eigen::Vector3d(3, 3, 3), Eigen::Vector3d(1e4, 0.5, 1e4),
                                        Eigen::Vector3d(1e5, 0.1, 0.1));
  const Eigen::AlignedBox3d region(-0.5 * size, 0.5 * size);
  const double resolution = fit_resolution(region, 0.005);
  CHECK(count_voxels(region, resolution) <= OccupancyGrid::kMaxVoxels);
  CHECK(count_voxels(region, 0.8 * resolution) > OccupancyGrid::kMaxVoxels);
  CHECK(fit_resolution(cube(kOrigin, 1.0), 0.005) == 0.005);  // what fits is mapped as asked for
}

TEST_CASE("of boxes too far apart for one map those nearest to the viewpoint stay",
          "[space][limits]") {
  const std::vector<Eigen::AlignedBox3d> boxes = {cube({0, 0, 100}, 0.5), cube({0, 0, 1}, 0.5),
                                                  cube({90, 90, 90}, 0.5), cube({1, 0, 1}, 0.5),
                                                  cube({0, 1e9, 0}, 0.5)};
  CHECK(find_far_boxes(boxes, kOrigin, 0.005) == std::vector<std::size_t>{2, 4});
  CHECK(find_far_boxes(boxes, {90, 90, 90}, 0.005) == std::vector<std::size_t>{0, 1, 3, 4});
}

TEST_CASE("boxes without bounds, or out of OctoMap's range, are far", "[space][limits]") {
  const double infinite = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {infinite, nan, 161.0}) {
    CHECK(find_far_boxes({cube({x, 0, 0}, 0.5)}, kOrigin, 0.005).size() == 1);
  }
  CHECK(find_far_boxes({cube({159.0, 0, 0}, 0.5)}, kOrigin, 0.005).empty());
}

TEST_CASE("a thin box that is vast is far, however near it begins", "[space][limits]") {
  const Eigen::AlignedBox3d plate(Eigen::Vector3d(-70, 0, 0.5), Eigen::Vector3d(70, 0.1, 150));
  CHECK(find_far_boxes({plate, cube({0, 0, 1}, 0.5)}, kOrigin, 0.005) ==
        std::vector<std::size_t>{0});
}

TEST_CASE("a grid of too many voxels is refused", "[space][limits]") {
  CHECK_THROWS_AS(OccupancyGrid(cube(kOrigin, 10.0), 0.005), std::invalid_argument);
}

TEST_CASE("a long map that is turned askew stays within the bound", "[space][limits]") {
  const Eigen::AlignedBox3d rod(kOrigin, Eigen::Vector3d(20.0, 0.05, 0.05));
  const OccupancyGrid grid(rod, 0.005);
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized()));
  const OccupancyGrid moved = grid.moved(turn);
  CHECK(static_cast<double>(moved.states().size()) <= OccupancyGrid::kMaxVoxels);
  CHECK(moved.resolution() > grid.resolution());
}

// Space that is decided where it is asked for, against the same space decided everywhere.
#include "space/space_on_demand.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "grasping/mapped_scene.hpp"
#include "grasping/random_box.hpp"
#include "space/obstacle_map.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

const Eigen::AlignedBox3d kWideRegion(Eigen::Vector3d(-0.3, -0.5, 0.4),
                                      Eigen::Vector3d(0.3, 0.15, 0.95));
// Free space is sought in a part of the region only.
const std::vector<Eigen::AlignedBox3d> kWanted = {
    {Eigen::Vector3d(-0.3, -0.5, 0.4), Eigen::Vector3d(0.1, 0.15, 0.8)}};

OccupancyGrid decided_everywhere(const Scene& scene, const Eigen::Vector3d& up,
                                 const std::vector<PointCloud>& more = {}) {
  SpaceMapper mapper(kWideRegion, kResolution, kWanted);
  mapper.add(scene.cloud, scene.view);
  for (const PointCloud& cloud : more) mapper.add(cloud, DepthView(cloud));
  return std::move(mapper).take_cleared(scene.view, up);
}

OccupancyGrid decided_on_demand(const Scene& scene, const Eigen::Vector3d& up,
                                const std::vector<PointCloud>& more = {}) {
  SpaceMapper mapper(kWideRegion, kResolution, kWanted);
  mapper.add_points(scene.cloud, scene.view.stray());
  auto views = std::make_shared<std::vector<DepthView>>(1, scene.view);
  for (const PointCloud& cloud : more) {
    views->emplace_back(cloud);
    mapper.add_points(cloud, views->back().stray());
  }
  return std::move(mapper).take_on_demand(std::move(views), up, {});
}

std::vector<Eigen::Vector3d> centres(const OccupancyGrid& grid) {
  std::vector<Eigen::Vector3d> all;
  for (int k = 0; k < grid.size().z(); ++k) {
    for (int j = 0; j < grid.size().y(); ++j) {
      for (int i = 0; i < grid.size().x(); ++i) all.push_back(grid.centre(i, j, k));
    }
  }
  return all;
}

}  // namespace

TEST_CASE("a voxel has the same state whether it is asked for or all are", "[occupancy]") {
  const Scene scene;
  const Eigen::Vector3d up = table_detection().X_CQ.linear().col(2);
  for (const Eigen::Vector3d& above : {up, Eigen::Vector3d(-up), Eigen::Vector3d(0, 0, 0)}) {
    const OccupancyGrid expected = decided_everywhere(scene, above);
    const OccupancyGrid grid = decided_on_demand(scene, above);
    CHECK(grid.size() == expected.size());
    std::vector<Eigen::Vector3d> order = centres(expected);
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    order.resize(order.size() / 3);
    long wrong = 0;
    for (const Eigen::Vector3d& p_C : order) wrong += grid.at(p_C) != expected.at(p_C);
    CHECK(wrong == 0);
    CHECK((grid.states() == expected.states()));
    // A grid that is copied before its voxels are decided has the same voxels.
    const OccupancyGrid copy = decided_on_demand(scene, above);
    CHECK((OccupancyGrid(copy).states() == expected.states()));
  }
}

TEST_CASE("a voxel is free if any of several views saw it free", "[occupancy]") {
  const Scene scene;
  const Eigen::Vector3d up = table_detection().X_CQ.linear().col(2);
  // A second camera stands 20 cm beside the first. It sees the same picture, but only its upper
  // half.
  PointCloud beside = scene.cloud;
  const Eigen::Vector3f shift(0.2f, 0.0f, 0.0f);
  for (Eigen::Vector3f& p : beside.points) p += shift;
  beside.viewpoint += shift.cast<double>();
  const auto half = static_cast<std::ptrdiff_t>(beside.points.size() / 2);
  std::fill(beside.points.begin() + half, beside.points.end(),
            Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  const OccupancyGrid alone = decided_everywhere(scene, up);
  const OccupancyGrid expected = decided_everywhere(scene, up, {beside});
  CHECK((alone.states() != expected.states()));
  const OccupancyGrid grid = decided_on_demand(scene, up, {beside});
  long wrong = 0;
  for (const Eigen::Vector3d& p_C : centres(expected)) wrong += grid.at(p_C) != expected.at(p_C);
  CHECK(wrong == 0);
  CHECK((grid.states() == expected.states()));
}

TEST_CASE("threads that ask for the same space at once get the same answers", "[occupancy]") {
  const Scene scene;
  const Eigen::Vector3d up = table_detection().X_CQ.linear().col(2);
  const OccupancyGrid expected = decided_everywhere(scene, up);
  const OccupancyGrid grid = decided_on_demand(scene, up);
  const std::vector<Eigen::Vector3d> all = centres(expected);
  std::vector<long> wrong(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < wrong.size(); ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t n = t; n < all.size(); n += 2) {
        wrong[t] += grid.at(all[n]) != expected.at(all[n]);
      }
      if (t == 3) wrong[t] += grid.states() != expected.states();
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == std::vector<long>(4, 0));
}

TEST_CASE("hands meet the same voxels of space that is not decided yet", "[occupancy]") {
  const Scene scene;
  const OccupancyGrid all = decided_everywhere(scene, Eigen::Vector3d::Zero());
  const OccupancyGrid grid = decided_on_demand(scene, Eigen::Vector3d::Zero());
  for (const bool unknown_blocks : {false, true}) {
    const ObstacleMap expected(all, unknown_blocks), map(grid, unknown_blocks);
    std::mt19937 random(11);
    int hits = 0;
    for (int n = 0; n < 2000; ++n) {
      const OrientedBox box = random_box(random, kWideRegion);
      const Hit hit = expected.collides(box);
      REQUIRE(map.collides(box) == hit);
      hits += hit != Hit::kNone;
    }
    CHECK(hits > 100);
  }
}

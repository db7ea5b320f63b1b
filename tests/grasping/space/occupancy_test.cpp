#include "quadrille/grasping/occupancy.hpp"

#include <octomap/OcTree.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "grasping/mapped_scene.hpp"
#include "grasping/octree_overlap.hpp"
#include "grasping/seen_space.hpp"
#include "space/collision.hpp"
#include "space/space_mapper.hpp"
#include "support/catch.hpp"
#include "view/depth_view.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Independent of DepthView: every pixel of the image against the voxel.
bool all_rays_pass(const Scene& scene, const Eigen::Vector3d& centre, double half) {
  int rays = 0;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray = pixel_ray(u, v);
      double enter = 0.0, leave = 1e9;
      for (int i = 0; i < 3; ++i) {
        const double a = (centre[i] - half) / ray[i], b = (centre[i] + half) / ray[i];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
      }
      if (enter > leave) continue;
      ++rays;
      const double depth = ray_depth(ray, scene.balls);  // infinite: nothing was measured
      if (!(depth > leave) || std::isinf(depth)) return false;
    }
  }
  return rays > 0;
}

}  // namespace

TEST_CASE("a voxel is free exactly if every ray through it passes", "[occupancy]") {
  const Scene scene;
  std::mt19937 random(6);
  const Eigen::Vector3i size = scene.grid.size();
  int free = 0, hidden = 0;
  for (int n = 0; n < 300; ++n) {
    const int i = static_cast<int>(random() % size.x()), j = static_cast<int>(random() % size.y());
    const int k = static_cast<int>(random() % size.z());
    const Voxel state = scene.grid.at(i, j, k);
    const bool pass = all_rays_pass(scene, scene.grid.centre(i, j, k), 0.5 * kResolution);
    CAPTURE(i, j, k, static_cast<int>(state));
    if (state != Voxel::kOccupied) REQUIRE((state == Voxel::kFree) == pass);
    free += pass;
    hidden += state == Voxel::kUnknown;
  }
  CHECK(free > 30);
  CHECK(hidden > 30);
}

TEST_CASE("no voxel is wrong against every ray of the image", "[occupancy]") {
  const Scene scene;
  const Wrong wrong = compare(scene.grid, scene.view);
  CHECK(wrong.free == 0);
  CHECK(wrong.unknown == 0);
  CHECK(wrong.undecided < 300);  // rays along the diagonal of the image graze edges
  CHECK(wrong.right_free > 20000);
}

TEST_CASE("nor is one with missing pixels, a turned camera or gaps that are filled",
          "[occupancy]") {
  Scene scene;
  std::mt19937 random(12);
  for (Eigen::Vector3f& p : scene.cloud.points) {
    if (random() % 12 == 0) p.setConstant(std::nanf(""));
  }
  const bool turned = GENERATE(false, true);
  const Eigen::Isometry3d X = turned ? random_pose(random) : Eigen::Isometry3d::Identity();
  for (Eigen::Vector3f& p : scene.cloud.points) p = X.cast<float>() * p;
  scene.cloud.viewpoint = X.translation();
  Eigen::AlignedBox3d region;
  for (int n = 0; n < 8; ++n) {
    region.extend(X * kRegion.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n)));
  }
  const DepthView view(scene.cloud, 0.09, kResolution);
  const OccupancyGrid grid = map_of(scene.cloud, view, region);
  const Wrong wrong = compare(grid, view);
  CHECK(wrong.free == 0);
  CHECK(wrong.unknown == 0);
  CHECK(wrong.undecided < 300);
  CHECK(wrong.right_free > 10000);
}

TEST_CASE("space behind the viewpoint is unknown", "[occupancy]") {
  const Scene scene;
  const Eigen::AlignedBox3d behind(Eigen::Vector3d(-0.3, -0.3, -1.0),
                                   Eigen::Vector3d(0.3, 0.3, -0.1));
  SpaceMapper mapper(behind, kResolution);
  mapper.add(scene.cloud, scene.view);
  const OccupancyGrid grid = std::move(mapper).take();
  CHECK(std::all_of(grid.states().begin(), grid.states().end(),
                    [](Voxel state) { return state == Voxel::kUnknown; }));

  // Not even what lies above free space is clear there, wherever the blocks lie.
  const Eigen::AlignedBox3d around(Eigen::Vector3d(-0.3, -0.3, -0.3),
                                   Eigen::Vector3d(0.3, 0.3, 0.5));
  SpaceMapper all(around, kResolution);
  all.add(scene.cloud, scene.view);
  const OccupancyGrid cleared = std::move(all).take_cleared(scene.view, -Eigen::Vector3d::UnitZ());
  int known = 0, before = 0;
  for (int k = 0; k < cleared.size().z(); ++k) {
    for (int j = 0; j < cleared.size().y(); ++j) {
      for (int i = 0; i < cleared.size().x(); ++i) {
        const bool is_known = cleared.at(i, j, k) != Voxel::kUnknown;
        (cleared.centre(i, j, k).z() < 0.0 ? known : before) += is_known;
      }
    }
  }
  CHECK(known == 0);
  CHECK(before > 1000);
}

TEST_CASE("every point's voxel is occupied, the inside of things unknown", "[occupancy]") {
  const Scene scene;
  int within = 0;
  for (std::size_t n = 0; n < scene.cloud.points.size(); ++n) {
    const Eigen::Vector3d p = scene.cloud.points[n].cast<double>();
    if (scene.view.stray()[n] || !kRegion.contains(p)) continue;
    ++within;
    REQUIRE(scene.grid.at(p) == Voxel::kOccupied);
  }
  CHECK(within > 1000);
  CHECK(scene.grid.at(scene.balls[0].p_C) == Voxel::kUnknown);
  CHECK(scene.grid.at(Eigen::Vector3d(5, 5, 5)) == Voxel::kUnknown);
}

TEST_CASE("a single stray point neither occupies nor hides", "[occupancy]") {
  Scene scene;
  PointCloud cloud = scene.cloud;
  const Eigen::Vector3d before = Eigen::Vector3d(0.0, -0.02, 0.70);
  const int u = static_cast<int>(before.x() / before.z() * kFocal + 0.5 * (kWidth - 1) + 0.5);
  const int v = static_cast<int>(before.y() / before.z() * kFocal + 0.5 * (kHeight - 1) + 0.5);
  const Eigen::Vector3d stray = 0.70 * pixel_ray(u, v);
  cloud.points[v * kWidth + u] = stray.cast<float>();
  const DepthView view(cloud);
  CHECK(view.stray()[v * kWidth + u] == 1);
  const OccupancyGrid grid = map_of(cloud, view);
  CHECK(grid.at(stray) == Voxel::kFree);
}

TEST_CASE("a cloud without its rows and columns gives the same map", "[occupancy]") {
  const Scene scene;
  PointCloud loose = scene.cloud;
  std::erase_if(loose.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  loose.width = loose.height = 0;
  const DepthView view(loose);
  const OccupancyGrid grid = map_of(loose, view);
  CHECK(grid.states() == scene.grid.states());
}

TEST_CASE("points in no order still map the open space as free and the hidden as unknown",
          "[occupancy]") {
  const Scene scene;
  PointCloud loose = scene.cloud;
  std::erase_if(loose.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  loose.width = loose.height = 0;
  std::mt19937 random(8);
  for (std::size_t i = loose.points.size(); i > 1; --i) {
    std::swap(loose.points[i - 1], loose.points[random() % i]);
  }
  const OccupancyGrid grid = map_of(loose, DepthView(loose));
  std::size_t both = 0, lost = 0, gained = 0;
  for (std::size_t n = 0; n < grid.states().size(); ++n) {
    const bool a = scene.grid.states()[n] == Voxel::kFree, b = grid.states()[n] == Voxel::kFree;
    both += a && b;
    lost += a && !b;
    gained += scene.grid.states()[n] == Voxel::kUnknown && b;
  }
  CHECK(lost < both / 4);
  CHECK(gained < both / 100);
}

TEST_CASE("the octree tells the same as the grid everywhere", "[occupancy][octree]") {
  const Scene scene;
  const auto tree = scene.grid.to_octree();
  const Eigen::Vector3i size = scene.grid.size();
  for (int k = 0; k < size.z(); ++k) {
    for (int j = 0; j < size.y(); ++j) {
      for (int i = 0; i < size.x(); ++i) {
        const Eigen::Vector3d c = scene.grid.centre(i, j, k);
        const auto state = [&](const octomap::OcTree& t) {
          const octomap::OcTreeNode* node = t.search(c.x(), c.y(), c.z());
          if (!node) return Voxel::kUnknown;
          return t.isNodeOccupied(node) ? Voxel::kOccupied : Voxel::kFree;
        };
        const Voxel expected = scene.grid.at(i, j, k);
        REQUIRE(state(*tree) == expected);
      }
    }
  }
}

TEST_CASE("an empty cloud or region maps nothing and stops nothing but the unknown",
          "[occupancy][hostile]") {
  const PointCloud empty;
  const DepthView view(empty);
  CHECK_FALSE(view.valid());
  const OccupancyGrid nothing = map_of(empty, view, {});
  CHECK(nothing.states().empty());
  CHECK(nothing.to_octree()->size() == 0);
  const OrientedBox box{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                        Eigen::Vector3d::Constant(0.1)};
  CHECK(ObstacleMap(nothing, false).collides(box) == Hit::kNone);
  CHECK(ObstacleMap(nothing, true).collides(box) == Hit::kUnknown);
  CHECK_FALSE(overlaps(box, std::shared_ptr<const octomap::OcTree>(nothing.to_octree())));
}

TEST_CASE("a region beyond the map's range is refused", "[occupancy][hostile]") {
  const Eigen::AlignedBox3d far(Eigen::Vector3d::Constant(1e6), Eigen::Vector3d::Constant(1e6 + 1));
  CHECK_THROWS_AS(OccupancyGrid(far, 0.005), std::invalid_argument);
  CHECK_THROWS_AS(OccupancyGrid(far, 0.0), std::invalid_argument);
}

TEST_CASE("two views fused are free where one is, and occupied where one is", "[occupancy][fuse]") {
  const Scene scene;
  Scene other;  // the same balls from the side
  const Eigen::Isometry3d turn = Eigen::Translation3d(0, 0, 0.8) *
                                 Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()) *
                                 Eigen::Translation3d(0, 0, -0.8);
  std::vector<Ball> balls = scene.balls;
  for (Ball& ball : balls) ball.p_C = turn.inverse() * ball.p_C;
  other.cloud = render(balls);
  for (Eigen::Vector3f& p : other.cloud.points) p = turn.cast<float>() * p;
  other.cloud.viewpoint = turn.translation();
  const DepthView view(other.cloud);
  const OccupancyGrid alone = map_of(other.cloud, view);
  const bool first = GENERATE(true, false);  // in either order
  SpaceMapper mapper(kRegion, kResolution);
  if (first) mapper.add(scene.cloud, scene.view);
  mapper.add(other.cloud, view);
  if (!first) mapper.add(scene.cloud, scene.view);
  CHECK_THROWS_AS(mapper.add(scene.cloud, DepthView(PointCloud())), std::invalid_argument);
  const OccupancyGrid both = std::move(mapper).take();
  int gained = 0;
  for (std::size_t n = 0; n < both.states().size(); ++n) {
    REQUIRE(both.states()[n] == std::max(scene.grid.states()[n], alone.states()[n]));
    gained += both.states()[n] == Voxel::kFree && scene.grid.states()[n] == Voxel::kUnknown;
  }
  CHECK(gained > 500);
}

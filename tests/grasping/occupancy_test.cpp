#include "quadrille/grasping/occupancy.hpp"

#include <octomap/OcTree.h>

#include <stdexcept>

#include "quadrille/grasping/collision.hpp"
#include "scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kResolution = 0.005;
const Eigen::AlignedBox3d kRegion(Eigen::Vector3d(-0.15, -0.15, 0.65),
                                  Eigen::Vector3d(0.15, 0.15, 0.95));

struct Scene {
  std::vector<Ball> balls = {ball_on_table(0.0, 0.0, 0.03), ball_on_table(0.09, 0.02, 0.025)};
  PointCloud cloud = render(balls);
  DepthView view{cloud};
  OccupancyGrid grid{cloud, view, kRegion, kResolution};
};

// Independent of DepthView: every pixel of the image against the voxel.
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

OrientedBox random_box(std::mt19937& random) {
  OrientedBox box;
  box.R_CB = random_rotation(random);
  box.p_CB =
      random_point(random, {Eigen::Vector3d(-0.1, -0.1, 0.7), Eigen::Vector3d(0.1, 0.1, 0.9)});
  for (int i = 0; i < 3; ++i) box.half[i] = uniform(random, 0.002, 0.03);
  return box;
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

TEST_CASE("voxels near surfaces are as conservative as those in the open", "[occupancy]") {
  const Scene scene;
  std::mt19937 random(7);
  const OccupancyGrid& grid = scene.grid;
  int free = 0, blocked = 0;
  for (int n = 0; n < 250; ++n) {
    const Ball& ball = scene.balls[n % 2];
    const Eigen::Vector3d p =
        ball.p_C + (ball.radius + uniform(random, 0.0, 0.012)) * random_rotation(random).col(0);
    const Eigen::Vector3i at =
        (p / kResolution).array().floor().cast<int>().matrix() - grid.corner();
    const Voxel state = grid.at(p);
    const bool pass = all_rays_pass(scene, grid.centre(at.x(), at.y(), at.z()), 0.5 * kResolution);
    if (state == Voxel::kFree) REQUIRE(pass);
    free += state == Voxel::kFree;
    blocked += !pass;
  }
  CHECK(free > 20);
  CHECK(blocked > 20);
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
  const OccupancyGrid grid(cloud, view, kRegion, kResolution);
  CHECK(grid.at(stray) == Voxel::kFree);
}

TEST_CASE("a cloud without its rows and columns gives the same map", "[occupancy]") {
  const Scene scene;
  PointCloud loose = scene.cloud;
  std::erase_if(loose.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  loose.width = loose.height = 0;
  const DepthView view(loose);
  const OccupancyGrid grid(loose, view, kRegion, kResolution);
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
  const OccupancyGrid grid(loose, DepthView(loose), kRegion, kResolution);
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
  const auto solid = scene.grid.to_octree(true);
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
        REQUIRE((state(*solid) == Voxel::kFree) == (expected == Voxel::kFree));
      }
    }
  }
}

TEST_CASE("the box test agrees with FCL on the octree", "[occupancy][collision]") {
  const Scene scene;
  const std::shared_ptr<const octomap::OcTree> tree = scene.grid.to_octree();
  const std::shared_ptr<const octomap::OcTree> solid = scene.grid.to_octree(true);
  const ObstacleMap occupied(scene.grid, false), blocked(scene.grid, true);
  std::mt19937 random(9);
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    const OrientedBox box = random_box(random);
    const bool hit = occupied.collides(box) != Hit::kNone;
    REQUIRE(hit == overlaps(box, tree));
    REQUIRE((blocked.collides(box) != Hit::kNone) == overlaps(box, solid));
    hits += hit;
  }
  CHECK(hits > 300);
  CHECK(hits < 2900);
}

TEST_CASE("a box is free up to a voxel's face and hits beyond", "[occupancy][collision]") {
  PointCloud cloud;
  cloud.points = {Eigen::Vector3f(0.0025F, 0.0025F, 0.5025F)};
  const OccupancyGrid grid(cloud, DepthView(cloud),
                           {Eigen::Vector3d(-0.05, -0.05, 0.45), Eigen::Vector3d(0.05, 0.05, 0.55)},
                           kResolution);
  // Its only pixel is a stray, so the voxel is made occupied by a cluster.
  PointCloud cluster = cloud;
  for (int i = 0; i < 49; ++i) {
    cluster.points.emplace_back(0.0005F + 0.0005F * (i % 7), 0.0005F + 0.0005F * (i / 7), 0.5025F);
  }
  const OccupancyGrid one(cluster, DepthView(cluster),
                          {Eigen::Vector3d(-0.05, -0.05, 0.45), Eigen::Vector3d(0.05, 0.05, 0.55)},
                          kResolution);
  REQUIRE(one.at({0.0025, 0.0025, 0.5025}) == Voxel::kOccupied);
  const ObstacleMap map(one, false);
  const auto tree = std::shared_ptr<const octomap::OcTree>(one.to_octree());
  for (const double gap : {-1e-4, 1e-4}) {
    const OrientedBox box{Eigen::Matrix3d::Identity(),
                          {0.005 + 0.01 + gap, 0.0025, 0.5025},
                          Eigen::Vector3d::Constant(0.01)};
    CHECK((map.collides(box) != Hit::kNone) == (gap < 0));
    CHECK(overlaps(box, tree) == (gap < 0));
  }
}

TEST_CASE("no box that holds an occupied voxel's centre is told free", "[occupancy][collision]") {
  const Scene scene;
  const ObstacleMap map(scene.grid, false);
  std::vector<Eigen::Vector3d> centres;
  const Eigen::Vector3i size = scene.grid.size();
  for (int k = 0; k < size.z(); ++k) {
    for (int j = 0; j < size.y(); ++j) {
      for (int i = 0; i < size.x(); ++i) {
        if (scene.grid.at(i, j, k) == Voxel::kOccupied)
          centres.push_back(scene.grid.centre(i, j, k));
      }
    }
  }
  std::mt19937 random(10);
  for (int n = 0; n < 1000; ++n) {
    const OrientedBox box = random_box(random);
    const bool holds = std::any_of(centres.begin(), centres.end(),
                                   [&](const Eigen::Vector3d& c) { return box.contains(c); });
    if (holds) REQUIRE(map.collides(box) == Hit::kOccupied);
  }
}

TEST_CASE("policies are ordered: free space grows from obstacle to shadow to free",
          "[occupancy][policy]") {
  const Scene scene;
  const Body body = make_body(sphere_detection(scene.balls[0])).value();
  const ObstacleMap obstacle(scene.grid, true), free(scene.grid, false);
  ObstacleMap shadow(scene.grid, true);
  shadow.clear_shadow(scene.grid, scene.view, body, kRegion);
  std::mt19937 random(11);
  int between = 0, above = 0;
  for (int n = 0; n < 4000; ++n) {
    OrientedBox box = random_box(random);
    box.half *= 0.3;
    const bool a = obstacle.collides(box) != Hit::kNone, b = shadow.collides(box) != Hit::kNone;
    const bool c = free.collides(box) != Hit::kNone;
    REQUIRE(a >= b);
    REQUIRE(b >= c);
    between += a && !b;
    above += b && !c;
  }
  CHECK(between > 20);
  CHECK(above > 20);
}

TEST_CASE("carving frees the target and keeps what is asked for", "[occupancy][carve]") {
  const Scene scene;
  const Body body = make_body(sphere_detection(scene.balls[0])).value();
  ObstacleMap map(scene.grid, true);
  const OrientedBox inside{Eigen::Matrix3d::Identity(), scene.balls[0].p_C,
                           Eigen::Vector3d::Constant(0.012)};
  const OrientedBox other{Eigen::Matrix3d::Identity(), scene.balls[1].p_C,
                          Eigen::Vector3d::Constant(0.012)};
  REQUIRE(map.collides(inside) != Hit::kNone);
  ObstacleMap kept = map;
  kept.carve(body, 0.006, [](const Eigen::Vector3d&) { return true; });
  CHECK(kept.collides(inside) != Hit::kNone);
  map.carve(body, 0.006, [](const Eigen::Vector3d&) { return false; });
  CHECK(map.collides(inside) == Hit::kNone);
  CHECK(map.collides(other) != Hit::kNone);
}

TEST_CASE("an empty cloud or region maps nothing and stops nothing but the unknown",
          "[occupancy][hostile]") {
  const PointCloud empty;
  const DepthView view(empty);
  CHECK_FALSE(view.valid());
  const OccupancyGrid nothing(empty, view, {}, kResolution);
  CHECK(nothing.states().empty());
  CHECK(nothing.to_octree()->size() == 0);
  const OrientedBox box{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                        Eigen::Vector3d::Constant(0.1)};
  CHECK(ObstacleMap(nothing, false).collides(box) == Hit::kNone);
  CHECK(ObstacleMap(nothing, true).collides(box) == Hit::kUnknown);
  CHECK_FALSE(overlaps(box, std::shared_ptr<const octomap::OcTree>(nothing.to_octree())));
}

TEST_CASE("a region beyond the map's range is refused", "[occupancy][hostile]") {
  const PointCloud empty;
  const DepthView view(empty);
  const Eigen::AlignedBox3d far(Eigen::Vector3d::Constant(1e6), Eigen::Vector3d::Constant(1e6 + 1));
  CHECK_THROWS_AS(OccupancyGrid(empty, view, far, 0.005), std::invalid_argument);
  CHECK_THROWS_AS(OccupancyGrid(empty, view, far, 0.0), std::invalid_argument);
}

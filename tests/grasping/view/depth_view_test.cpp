#include "view/depth_view.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "grasping/mapped_scene.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// The interval of t in which the ray t·d is in the box p_C ± half; empty if first > second.
std::pair<double, double> crossing(const Eigen::Vector3d& p_C, const Eigen::Array3d& half,
                                   const Eigen::Vector3d& ray) {
  const Eigen::Array3d t0 = (p_C.array() - half) / ray.array();
  const Eigen::Array3d t1 = (p_C.array() + half) / ray.array();
  return {t0.min(t1).maxCoeff(), t0.max(t1).minCoeff()};
}

}  // namespace

TEST_CASE("the image is the depth that was rendered, pixel by pixel", "[view]") {
  const Scene scene;
  // The view begins with the first row and column that measured anything.
  const Eigen::Vector3d ray = scene.view.ray_C(0, 0);
  const int u0 = static_cast<int>(std::lround(ray.x() * kFocal + 0.5 * (kWidth - 1)));
  const int v0 = static_cast<int>(std::lround(ray.y() * kFocal + 0.5 * (kHeight - 1)));
  int measured = 0;
  for (int v = 0; v < scene.view.height(); ++v) {
    for (int u = 0; u < scene.view.width(); ++u) {
      CHECK((scene.view.ray_C(u, v) - pixel_ray(u + u0, v + v0)).norm() < 1e-6);
      const double depth = ray_depth(pixel_ray(u + u0, v + v0), scene.balls);
      if (std::isinf(depth)) continue;
      ++measured;
      REQUIRE(scene.view.depth(u, v) == Approx(depth).epsilon(1e-6));
    }
  }
  CHECK(measured > 20000);
  CHECK(scene.view.depth(-1, 0) == 0.0);
  CHECK(scene.view.depth(0, scene.view.height()) == 0.0);
}

TEST_CASE("bounds of the depth hold that of every pixel whose ray passes the box", "[view]") {
  const Scene scene;
  const DepthView& view = scene.view;
  std::mt19937 random(71);
  int passed = 0;
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector3d p = random_point(random, kRegion);
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(uniform(random, 0.002, 0.03));
    const DepthRange range = view.range(view.to_view(p), reach);
    for (int v = 0; v < view.height(); ++v) {
      for (int u = 0; u < view.width(); ++u) {
        const Eigen::Vector3d ray = view.to_view(view.p_CV() + view.ray_C(u, v));
        const auto [enter, leave] = crossing(view.to_view(p), reach.array(), ray);
        if (enter > leave) continue;
        ++passed;
        REQUIRE(range.min <= view.depth(u, v));
        REQUIRE(range.max >= view.depth(u, v));
      }
    }
  }
  CHECK(passed > 5000);
}

TEST_CASE("eight boxes at once have the bounds of each, or wider ones", "[view]") {
  const Scene scene;
  const DepthView& view = scene.view;
  std::mt19937 random(72);
  int equal = 0;
  for (int n = 0; n < 500; ++n) {
    DepthView::EightPoints eight;
    const Eigen::AlignedBox3d near(Eigen::Vector3d(-0.3, -0.3, n % 5 ? 0.5 : 0.0),
                                   Eigen::Vector3d(0.3, 0.3, 1.2));
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(uniform(random, 0.001, 0.01));
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector3f p_V = random_point(random, near).cast<float>();
      eight.x[k] = p_V.x(), eight.y[k] = p_V.y(), eight.z[k] = p_V.z();
    }
    const auto ranges = view.ranges(eight, reach);
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector3d p_V(eight.x[k], eight.y[k], eight.z[k]);
      const DepthRange one = view.range(p_V, reach);
      REQUIRE(ranges[k].min <= one.min);
      REQUIRE(ranges[k].max >= one.max);
      equal += ranges[k].min == one.min && ranges[k].max == one.max;
    }
  }
  CHECK(equal > 3500);
}

TEST_CASE("a map restricted to boxes is the same within them, and tells no free space beyond",
          "[view][occupancy]") {
  const Scene scene;
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-0.05, -0.04, 0.72),
                                Eigen::Vector3d(0.0, 0.0, 0.8));
  SpaceMapper mapper(kRegion, kResolution, {box});
  mapper.add(scene.cloud, scene.view);
  const OccupancyGrid part = std::move(mapper).take();
  int within = 0, left_out = 0;
  const Eigen::Vector3i size = part.size();
  for (int n = 0; n < size.prod(); ++n) {
    const int i = n % size.x(), j = n / size.x() % size.y(), k = n / (size.x() * size.y());
    const Voxel whole = scene.grid.at(i, j, k), here = part.at(i, j, k);
    const bool inside = box.contains(part.centre(i, j, k));
    if (inside) REQUIRE(here == whole);
    if (here != whole) REQUIRE((whole == Voxel::kFree && here == Voxel::kUnknown));
    within += inside;
    left_out += here != whole;
  }
  CHECK(within > 1000);
  CHECK(left_out > 1000);
}

TEST_CASE("what stands before a thing hides it, and only what holds() says is to blame", "[view]") {
  const Scene scene;
  const Ball& ball = scene.balls[0];
  const Eigen::Vector3d behind = ball.p_C + 1.3 * ball.radius * ball.p_C.normalized();
  const auto on_ball = [&](const Eigen::Vector3d& p) {
    return std::abs((p - ball.p_C).norm() - ball.radius) < 0.001;
  };
  CHECK_FALSE(scene.view.sees_past(behind, 0.002));
  CHECK(scene.view.hidden_only_by(behind, 0.002, on_ball));
  CHECK_FALSE(scene.view.hidden_only_by(behind, 0.002, [](const auto&) { return false; }));
  const Eigen::Vector3d before = ball.p_C - 1.3 * ball.radius * ball.p_C.normalized();
  CHECK(scene.view.sees_past(before, 0.002));
  CHECK_FALSE(scene.view.hidden_only_by(before, 0.002, on_ball));
}

TEST_CASE("the nearest surface is the least depth that was measured around a box", "[view]") {
  const Scene scene;
  const DepthView& view = scene.view;
  std::mt19937 random(17);
  int none = 0, some = 0, met = 0;
  for (int n = 0; n < 600; ++n) {
    const Eigen::Vector3d p_C =
        random_point(random, {Eigen::Vector3d(-0.6, -0.6, 0.2), Eigen::Vector3d(0.6, 0.6, 1.4)});
    const double half = 0.002 + 0.00005 * n;
    const Eigen::Vector3d p_V = view.to_view(p_C), reach = view.reach(half);
    const double nearest = view.nearest_surface(p_V, reach);
    double least = std::numeric_limits<double>::infinity();
    bool meets = false;
    for (int v = 0; v < view.height(); ++v) {
      for (int u = 0; u < view.width(); ++u) {
        const double z = view.depth(u, v);
        const auto [enter, leave] = crossing(p_C, Eigen::Array3d::Constant(half), view.ray_C(u, v));
        if (z == 0.0 || enter > leave) continue;
        least = std::min(least, z);
        meets |= z <= leave;
      }
    }
    REQUIRE(nearest <= least);
    if (meets) REQUIRE(nearest <= p_V.z() + reach.z());
    if (meets) REQUIRE(view.meets_surface(p_C, half));
    none += std::isinf(nearest);
    some += nearest > p_V.z() + reach.z() && std::isfinite(nearest);
    met += meets;
  }
  CHECK(none > 100);
  CHECK(some > 10);
  CHECK(met > 100);
}

TEST_CASE("a view of points in disorder has no more pixels than any camera", "[view][hostile]") {
  PointCloud cloud;
  for (int n = 0; n < 20000; ++n) cloud.points.emplace_back(std::ldexp(1.0f * n, -30), 0.0f, 1.0f);
  for (int n = 0; n < 20; ++n) cloud.points.emplace_back(1.0f, 0.05f * n, 1.0f);
  const DepthView view(cloud);
  REQUIRE(view.valid());
  CHECK(static_cast<double>(view.width()) * view.height() <= 4e6);
}

TEST_CASE("without points or a viewpoint a view is invalid", "[view][degenerate]") {
  PointCloud nowhere = Scene().cloud;
  nowhere.viewpoint.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(DepthView(nowhere).valid());
  CHECK(DepthView(nowhere).stray().size() == nowhere.points.size());
  const DepthView empty{PointCloud()};
  const Eigen::Vector3d p_C(0.0, 0.0, 1.0), reach = Eigen::Vector3d::Constant(0.01);
  CHECK_FALSE(empty.valid());
  CHECK_FALSE(empty.sees_past(p_C, 0.01));
  CHECK_FALSE(empty.meets_surface(p_C, 0.01));
  CHECK(std::isinf(empty.nearest_surface(p_C, reach)));
  CHECK(empty.range(p_C, reach).max == 0.0);
}

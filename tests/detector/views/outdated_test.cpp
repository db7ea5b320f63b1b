// The memory forgets what older views saw if a newer view contradicts it, or if it is told to.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "detector/table_scene.hpp"
#include "detector/views/taken_views.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/view_memory.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::size_t finite_points(const PointCloud& cloud) {
  return static_cast<std::size_t>(
      std::count_if(cloud.points.begin(), cloud.points.end(),
                    [](const Eigen::Vector3f& p) { return p.allFinite(); }));
}

template <class Wanted>
int count_points(const PointCloud& cloud, const Wanted& wanted) {
  return static_cast<int>(std::count_if(
      cloud.points.begin(), cloud.points.end(),
      [&](const Eigen::Vector3f& p) { return p.allFinite() && wanted(p.cast<double>()); }));
}

bool on_ball(const Eigen::Vector3d& p_W) {
  return std::abs((p_W - kBall_W).norm() - kBall) < 0.006 && p_W.z() > 0.02;
}

/// Distance between a point and the segment from a to b.
double from_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int n = 0; n <= 400; ++n) nearest = std::min(nearest, (a + n / 400.0 * (b - a) - p).norm());
  return nearest;
}

}  // namespace

TEST_CASE("a thing that was taken away is gone from what older views saw", "[views][memory]") {
  ViewMemory memory;
  const Taken before = taken_from_eye(world_table(), eye_at(0));
  add_view(memory, 1 * kSecond, before);
  const PointCloud first = views_in_world(memory)[0];
  REQUIRE(count_points(first, on_ball) > 200);
  add_view(memory, 2 * kSecond, taken_from_eye(world_without_ball(), eye_at(60)));
  const std::vector<PointCloud> views = views_in_world(memory);
  REQUIRE(views.size() == 2);
  const PointCloud& older = views[1];
  CHECK(older.organised());
  CHECK(count_points(older, on_ball) == 0);
  // All that is far from the ball is still there.
  const auto elsewhere = [](const Eigen::Vector3d& p) { return (p - kBall_W).norm() > 0.12; };
  CHECK(count_points(older, elsewhere) > 0.98 * count_points(first, elsewhere));
}

TEST_CASE("nothing is left of the foot of a thing that was taken away", "[views][memory]") {
  const Eigen::Vector3d size(0.06, 0.06, 0.05), middle(0.0, -0.15, 0.025);
  std::vector<Patch> with_box = world_table();
  for (const Patch& face : box(Eigen::Isometry3d(Eigen::Translation3d(middle)), size)) {
    with_box.push_back(face);
  }
  const auto low_on_box = [&](const Eigen::Vector3d& p_W) {
    return ((p_W - middle).array().abs() < 0.5 * size.array() + 0.004).all() && p_W.z() > 0.01 &&
           p_W.z() < 0.03;
  };
  ViewMemory memory;
  add_view(memory, 1 * kSecond, taken_from_eye(with_box, eye_at(0)));
  REQUIRE(count_points(views_in_world(memory)[0], low_on_box) > 20);
  add_view(memory, 2 * kSecond, taken_from_eye(world_table(), eye_at(60)));
  CHECK(count_points(views_in_world(memory)[1], low_on_box) == 0);
}

TEST_CASE("what older views saw stays while nothing changes", "[views][memory]") {
  ViewMemory memory;
  add_view(memory, 1 * kSecond, taken_from_eye(world_table(), eye_at(0)));
  const std::size_t before = finite_points(views_in_world(memory)[0]);
  for (int n = 1; n < 6; ++n) {
    add_view(memory, (1 + n) * kSecond, taken_from_eye(world_table(), eye_at(60.0 * n)));
  }
  const std::vector<PointCloud> views = views_in_world(memory);
  REQUIRE(views.size() == 6);
  CHECK(static_cast<double>(finite_points(views.back())) > 0.98 * static_cast<double>(before));
}

TEST_CASE("where a thing was put down, older views tell of no free space any more",
          "[views][memory]") {
  ViewMemory memory;
  const Taken before = taken_from_eye(world_without_ball(), eye_at(0));
  add_view(memory, 1 * kSecond, before);
  const PointCloud first = views_in_world(memory)[0];
  add_view(memory, 2 * kSecond, taken_from_eye(world_table(), eye_at(60)));
  const std::vector<PointCloud> views = views_in_world(memory);
  REQUIRE(views.size() == 2);
  int through = 0, far = 0, far_kept = 0;
  for (std::size_t k = 0; k < first.points.size(); ++k) {
    if (!first.points[k].allFinite()) continue;
    const double gap = from_segment(kBall_W, eye_at(0), first.points[k].cast<double>());
    if (gap < kBall) {
      ++through;
      CHECK_FALSE(views[1].points[k].allFinite());
    } else if (gap > 0.2) {
      ++far;
      far_kept += views[1].points[k].allFinite();
    }
  }
  CHECK(through > 200);
  CHECK(far > 1000);
  CHECK(far_kept > 0.98 * far);
}

TEST_CASE("views are forgotten if one asks for it, all or those of a box", "[views][memory]") {
  ViewMemory memory;
  const bool organised = GENERATE(true, false);
  for (int n = 0; n < 2; ++n) {
    Taken view = taken_from_eye(world_table(), eye_at(80.0 * n));
    if (!organised) {
      view.cloud.width = view.cloud.height = 0;
      std::erase_if(view.cloud.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
    }
    add_view(memory, (1 + n) * kSecond, view);
  }
  REQUIRE(memory.size() == 2);
  const std::vector<PointCloud> all = views_in_world(memory);
  const Eigen::Isometry3d X_WR = Eigen::Translation3d(0.2, 0.0, 0.1) *
                                 Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 1, 2).normalized());
  const Eigen::Vector3d half(0.08, 0.06, 0.09);
  memory.forget(X_WR, {-half, half});
  const std::vector<PointCloud> left = views_in_world(memory);
  REQUIRE(left.size() == 2);
  const auto inside = [&](const Eigen::Vector3d& p_W, double grown) {
    const Eigen::Vector3d p_R = X_WR.linear().transpose() * (p_W - X_WR.translation());
    return (p_R.cwiseAbs().array() < half.array() + grown).all();
  };
  // Whether one of many places along the line of sight to a point lies in the box.
  const auto seen_through = [&](const PointCloud& view, double grown) {
    return [&inside, eye = view.viewpoint, grown](const Eigen::Vector3d& p_W) {
      constexpr int kSteps = 500;
      for (int n = 0; n <= kSteps; ++n) {
        if (inside(eye + (p_W - eye) * n / kSteps, grown)) return true;
      }
      return false;
    };
  };
  for (std::size_t v = 0; v < 2; ++v) {
    CHECK(left[v].organised() == organised);
    const auto through = seen_through(all[v], -0.003), near = seen_through(all[v], 0.003);
    const auto beside = [&](const Eigen::Vector3d& p_W) { return !near(p_W); };
    CHECK(count_points(all[v], through) > 100);
    CHECK(count_points(left[v], through) == 0);
    CHECK(count_points(all[v], beside) > 1000);
    CHECK(count_points(left[v], beside) == count_points(all[v], beside));
  }
  memory.forget();
  CHECK(memory.size() == 0);
  CHECK(views_in_world(memory).empty());
}

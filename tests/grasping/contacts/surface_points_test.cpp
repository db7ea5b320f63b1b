#include "contacts/surface_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "grasping/scenes.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kCell = 0.0025;
const Eigen::Vector3d kEye = Eigen::Vector3d::Zero();

/// The half of a ball that faces the sensor, and points a millimetre apart.
std::vector<Eigen::Vector3d> seen_half(const Ball& ball) {
  std::vector<Eigen::Vector3d> points;
  const int count = 12000;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, t = 2.399963 * i, r = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d n(r * std::cos(t), r * std::sin(t), z);
    const Eigen::Vector3d p = ball.p_C + ball.radius * n;
    if (n.dot(kEye - p) > 0.0) points.push_back(p);
  }
  return points;
}

/// The surface points of points that one eye saw.
SurfacePoints surface_points_of(const std::vector<Eigen::Vector3d>& points) {
  return surface_points(points, kCell, std::vector<Eigen::Vector3d>(points.size(), kEye));
}

}  // namespace

TEST_CASE("points are thinned to one for each cell, and their normals are those of the surface",
          "[contacts][points]") {
  const Ball ball{Eigen::Vector3d(0.02, -0.01, 0.7), 0.03};
  const SurfacePoints surface = surface_points_of(seen_half(ball));
  REQUIRE(surface.p_C.size() == surface.n_C.size());
  REQUIRE(surface.p_C.size() > 500);
  std::set<std::array<int, 3>> cells;
  for (std::size_t i = 0; i < surface.p_C.size(); ++i) {
    const Eigen::Vector3d& p = surface.p_C[i];
    const Eigen::Vector3i cell = ((p / kCell).array() + 0.37).floor().cast<int>();
    CHECK(cells.insert({cell.x(), cell.y(), cell.z()}).second);
    const Eigen::Vector3d outward = (p - ball.p_C).normalized();
    CHECK((p - ball.p_C).norm() == Approx(ball.radius).margin(0.0003));
    // Normals lean at the edge of the seen half, because neighbours are missing on one side.
    if (outward.dot((kEye - p).normalized()) < 0.4) continue;
    CHECK(surface.n_C[i].dot(outward) > std::cos(0.08));
  }
}

TEST_CASE("where one sensor's points end and another's begin a step turns no normal",
          "[contacts][points]") {
  // A plane, of which each sensor sees a half, one of them 2 mm off.
  std::vector<Eigen::Vector3d> points, eyes;
  for (double x = -0.03; x < 0.03; x += 0.001) {
    for (double y = -0.02; y < 0.02; y += 0.001) {
      points.emplace_back(x, y, x < 0.0 ? 0.5 : 0.502);
      eyes.emplace_back(x < 0.0 ? -0.1 : 0.1, 0.0, 0.0);
    }
  }
  const SurfacePoints surface = surface_points(points, kCell, eyes);
  REQUIRE(surface.p_C.size() > 300);
  for (const Eigen::Vector3d& n : surface.n_C) {
    if (!n.isZero()) CHECK(n.z() < -0.9999);
  }
}

TEST_CASE("the order of the points does not matter beyond rounding", "[contacts][points]") {
  std::vector<Eigen::Vector3d> points = seen_half({Eigen::Vector3d(0.0, 0.0, 0.6), 0.02});
  const SurfacePoints one = surface_points_of(points);
  std::reverse(points.begin(), points.end());
  const SurfacePoints other = surface_points_of(points);
  REQUIRE(one.p_C.size() == other.p_C.size());
  for (std::size_t i = 0; i < one.p_C.size(); ++i) {
    CHECK((one.p_C[i] - other.p_C[i]).norm() < 1e-12);
    CHECK(one.n_C[i].dot(other.n_C[i]) > 1.0 - 1e-6);
  }
}

TEST_CASE("points without neighbours have no normal", "[contacts][points]") {
  const std::vector<Eigen::Vector3d> points = {{0.0, 0.0, 0.5}, {0.03, 0.0, 0.5}, {0.0, 0.03, 0.5}};
  const SurfacePoints surface = surface_points_of(points);
  REQUIRE(surface.p_C.size() == 3);
  for (const Eigen::Vector3d& n : surface.n_C) CHECK(n.isZero());
  CHECK(surface_points_of({}).p_C.empty());
}

TEST_CASE("a box of a surface has the points and normals of the whole surface that lie in it",
          "[contacts][points]") {
  const Ball ball{Eigen::Vector3d(0.02, -0.01, 0.7), 0.03};
  const std::vector<Eigen::Vector3d> points = seen_half(ball);
  const PointSurface surface(points, kCell, std::vector<Eigen::Vector3d>(points.size(), kEye));
  const Eigen::AlignedBox3d box(ball.p_C - Eigen::Vector3d::Constant(0.1), ball.p_C);
  const SurfacePoints part = surface.within(box), whole = surface.all();
  std::size_t n = 0;
  for (std::size_t i = 0; i < whole.p_C.size(); ++i) {
    if (!box.contains(whole.p_C[i])) continue;
    REQUIRE(n < part.p_C.size());
    CHECK(part.p_C[n] == whole.p_C[i]);
    CHECK(part.n_C[n] == whole.n_C[i]);
    ++n;
  }
  CHECK(n > 100);
  CHECK(n == part.p_C.size());
}

TEST_CASE("threads that ask for a surface at once get the same bits",
          "[contacts][points][determinism]") {
  const std::vector<Eigen::Vector3d> points = seen_half({Eigen::Vector3d(0.0, 0.0, 0.6), 0.02});
  const std::vector<Eigen::Vector3d> eyes(points.size(), kEye);
  const SurfacePoints alone = surface_points(points, kCell, eyes);
  const PointSurface shared(points, kCell, eyes);
  std::array<SurfacePoints, 8> found;
  parallel_for(static_cast<int>(found.size()), static_cast<int>(found.size()),
               [&](int k) { found[k] = shared.all(); });
  for (const SurfacePoints& one : found) {
    CHECK(one.p_C == alone.p_C);
    CHECK(one.n_C == alone.n_C);
  }
}

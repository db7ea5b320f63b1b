#include "lab/bench/stability.hpp"

#include <algorithm>
#include <limits>

#include "lab/scoring/frame.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/exact_detection.hpp"

namespace quadrille::bench {
namespace {

using Runs = std::vector<std::vector<Detection>>;

/// A ball whose extent is a cube of 0.1 m, with a diagonal of 0.173 m.
Detection ball_at(double x, double score = 0.9) {
  Detection ball = test::exact_ball({x, 0.0, 1.0}, 0.05);
  ball.extent_Q = {Eigen::Vector3d::Constant(-0.05), Eigen::Vector3d::Constant(0.05)};
  ball.score = score;
  return ball;
}

Detection ellipsoid_at(double x) {
  Detection ellipsoid = ball_at(x);
  ellipsoid.type = QuadricType::kEllipsoid;
  return ellipsoid;
}

PointCloud easy_cloud() {
  return scoring::frame_of(scene::make_scene({scene::Family::kEasy, 1000})).cloud;
}

Eigen::Vector3f least(const PointCloud& cloud) {
  Eigen::Vector3f least = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
  for (const Eigen::Vector3f& p : cloud.points) least = least.cwiseMin(p);
  return least;
}

TEST_CASE("a surface that each run finds is in all, another only in any", "[bench][stability]") {
  const StabilityCounts counts =
      count_stable(Runs{{ball_at(0.0), ball_at(1.0)}, {ball_at(0.01)}, {ball_at(-0.01)}});
  CHECK(counts.in_any == 2);
  CHECK(counts.in_all == 1);
  CHECK(counts.same_type == 1);
}

TEST_CASE("the same surface may have another type in another run", "[bench][stability]") {
  const StabilityCounts counts = count_stable(Runs{{ball_at(0.0)}, {ellipsoid_at(0.0)}});
  CHECK(counts.in_any == 1);
  CHECK(counts.in_all == 1);
  CHECK(counts.same_type == 0);
}

TEST_CASE("surfaces are the same up to 0.7 of their size", "[bench][stability]") {
  CHECK(count_stable(Runs{{ball_at(0.0)}, {ball_at(0.12)}}).in_any == 1);
  CHECK(count_stable(Runs{{ball_at(0.0)}, {ball_at(0.13)}}).in_any == 2);
}

TEST_CASE("a detection is the nearest surface, and no surface twice", "[bench][stability]") {
  const Runs runs = {{ball_at(0.0), ball_at(0.06)}, {ball_at(0.05), ball_at(0.11)}};
  CHECK(count_stable(runs).in_any == 2);
  CHECK(count_stable(runs).in_all == 2);
  const StabilityCounts counts = count_stable(Runs{{ball_at(0.0)}, {ball_at(0.05), ball_at(0.11)}});
  CHECK(counts.in_any == 2);
  CHECK(counts.in_all == 1);
}

TEST_CASE("a surface is sure if a run gives it a score of 0.8", "[bench][stability]") {
  const StabilityCounts counts =
      count_stable(Runs{{ball_at(0.0, 0.6), ball_at(1.0, 0.8), ball_at(2.0, 0.7)},
                        {ball_at(0.0, 0.9), ball_at(2.0, 0.7)}});
  CHECK(counts.in_all == 2);
  CHECK(counts.sure_in_any == 2);
  CHECK(counts.sure_in_all == 1);
}

TEST_CASE("planes and what was not asked for do not count", "[bench][stability]") {
  Detection plane = ball_at(0.0), other = ball_at(1.0);
  plane.type = QuadricType::kPlane;
  other.id = -1;
  CHECK(count_stable(Runs{{plane, other}}).in_any == 0);
  CHECK(count_stable({}).in_any == 0);
}

TEST_CASE("a single view loses its first columns and rows", "[bench][stability]") {
  const PointCloud cloud = easy_cloud();
  CHECK(shifted(cloud, 0, {}).points == cloud.points);
  const PointCloud cropped = shifted(cloud, 3, {});
  // A scene has 640 columns and 480 rows, of which some pixels are missing.
  const double left = static_cast<double>(cropped.points.size()) / cloud.points.size();
  CHECK(left == Approx(637.0 / 640.0 * 477.0 / 480.0).margin(0.001));
}

TEST_CASE("the missing points of an organised cloud keep their places", "[bench][stability]") {
  PointCloud cloud = easy_cloud();
  cloud.width = static_cast<int>(cloud.points.size()) / 2;
  cloud.height = 2;
  const PointCloud cropped = shifted(cloud, 3, {});
  REQUIRE(cropped.points.size() == cloud.points.size());
  CHECK(std::any_of(cropped.points.begin(), cropped.points.end(),
                    [](const Eigen::Vector3f& p) { return !p.allFinite(); }));
}

TEST_CASE("another cloud than a single view moves by eighths of a cell", "[bench][stability]") {
  PointCloud cloud = easy_cloud();
  // The camera is in the midst of the points.
  cloud.viewpoint = {0.0, 0.0, 1.0};
  const DetectorOptions options;
  const PointCloud moved = shifted(cloud, 2, options);
  REQUIRE(moved.points.size() == cloud.points.size());
  const Eigen::Vector3f step = least(moved) - least(cloud);
  const float quarter = static_cast<float>(options.sampling.cell / 4.0);
  CHECK((step - Eigen::Vector3f::Constant(quarter)).norm() < 1e-6f);
  CHECK((moved.viewpoint - cloud.viewpoint).norm() == Approx(std::sqrt(3.0) * quarter));
}

}  // namespace
}  // namespace quadrille::bench

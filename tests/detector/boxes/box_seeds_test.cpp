#include "boxes/box_seeds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "box_samples.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

const Eigen::Vector3d kSize(0.08, 0.048, 0.064);

std::vector<BoxSeed> seeds_of(const SurfaceSamples& samples) {
  return find_box_seeds(samples, Mask(samples.p.size(), 1), {});
}

/// The mantle of a cylinder along y, and its lid at the lower end.
test::OrientedPoints can(double radius, double length, bool with_lid) {
  test::OrientedPoints all;
  const int around = static_cast<int>(2.0 * M_PI * radius / test::kSampleCell);
  for (int k = 0; k < around; ++k) {
    const double angle = 2.0 * M_PI * k / around;
    const Eigen::Vector3d n(std::cos(angle), 0.0, std::sin(angle));
    for (double y = -0.5 * length; y < 0.5 * length; y += test::kSampleCell) {
      all.p.push_back(radius * n + y * Eigen::Vector3d::UnitY());
      all.n.push_back(n);
    }
  }
  for (double x = -radius; with_lid && x < radius; x += test::kSampleCell) {
    for (double z = -radius; z < radius; z += test::kSampleCell) {
      if (std::hypot(x, z) > radius) continue;
      all.p.emplace_back(x, -0.5 * length, z);
      all.n.push_back(-Eigen::Vector3d::UnitY());
    }
  }
  return all;
}

TEST_CASE("the three sides of a box that a view shows are one seed with their planes and sizes",
          "[boxes][seeds]") {
  const Eigen::Isometry3d X_CB = test::showing_three_sides();
  for (const double noise : {0.0, 0.05, 0.1}) {
    INFO("noise of the normals " << noise);
    const auto seeds = seeds_of(test::seen_samples(test::sides_of_box(kSize), X_CB, noise));
    REQUIRE(seeds.size() == 1);
    REQUIRE(seeds[0].size() == 3);
    for (const FlatPatch& flat : seeds[0]) {
      CHECK(flat.sigma == Approx(0.0005));
      const Eigen::Isometry3d X_BP = X_CB.inverse() * flat.patch.X_CP;
      Eigen::Index axis = 0;
      CHECK(X_BP.linear().col(2).cwiseAbs().maxCoeff(&axis) > std::cos(0.01));
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      middle[axis] = std::copysign(0.5 * kSize[axis], X_BP.linear()(axis, 2));
      CHECK((X_BP.translation() - middle).norm() < 0.002);
      // The outermost samples lie half a cell within the edges.
      const double narrow = std::min(kSize[(axis + 1) % 3], kSize[(axis + 2) % 3]);
      CHECK(2.0 * flat.patch.half.minCoeff() == Approx(narrow - test::kSampleCell).margin(0.002));
    }
  }
}

TEST_CASE("a box of which a view shows two sides is a seed, and of one side none",
          "[boxes][seeds]") {
  const Eigen::Isometry3d ahead = test::translation(0.0, 0.0, 0.6);
  const Eigen::Isometry3d turned = ahead * Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitY());
  const test::OrientedPoints box = test::sides_of_box(kSize);
  const auto two = seeds_of(test::seen_samples(box, turned));
  REQUIRE(two.size() == 1);
  CHECK(two[0].size() == 2);
  CHECK(seeds_of(test::seen_samples(box, ahead)).empty());
}

TEST_CASE("a box that stands on a plane has a second seed, upright on the nearest plane below it",
          "[boxes][seeds]") {
  const Eigen::Isometry3d X_CB = test::showing_three_sides();
  const SurfaceSamples samples = test::seen_samples(test::sides_of_box(kSize), X_CB);
  const Eigen::Vector3d up_C = -X_CB.linear().col(1);
  // A plane below the box, a lower one that leans, one in the midst of the box, and a far wall.
  const Eigen::Vector3d leans_C = Eigen::AngleAxisd(0.3, X_CB.linear().col(0)) * up_C;
  const Eigen::Vector3d foot_C = X_CB.translation() - 0.5 * kSize.y() * up_C;
  const Eigen::Vector3d aside_C = X_CB.linear().col(0);
  const std::vector<Eigen::Hyperplane<double, 3>> floors = {
      {leans_C, Eigen::Vector3d(foot_C - 0.02 * up_C)},
      {up_C, foot_C},
      {leans_C, X_CB.translation()},
      {aside_C, Eigen::Vector3d(X_CB.translation() - 0.3 * aside_C)}};
  const auto seeds = find_box_seeds(samples, Mask(samples.p.size(), 1), floors);
  REQUIRE(seeds.size() == 2);
  for (const FlatPatch& flat : seeds[1]) {
    const Eigen::Vector3d n_B = X_CB.linear().transpose() * flat.patch.X_CP.linear().col(2);
    CHECK(n_B.cwiseAbs().maxCoeff() > std::cos(0.02));
  }
}

TEST_CASE("balls and the mantles of cylinders are no seeds", "[boxes][seeds]") {
  test::OrientedPoints ball;
  for (int k = 0; k < 3000; ++k) {
    // The spiral of the golden angle spreads points evenly over a sphere.
    const double y = 1.0 - (2.0 * k + 1.0) / 3000.0, angle = k * M_PI * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - y * y);
    ball.n.emplace_back(r * std::cos(angle), y, r * std::sin(angle));
    ball.p.push_back(0.05 * ball.n.back());
  }
  CHECK(seeds_of(test::seen_samples(ball, test::translation(0, 0, 0.6))).empty());
  for (const double turn : {0.0, 0.3, 0.7}) {
    const Eigen::Isometry3d X_CB =
        test::translation(0, 0, 0.6) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitX());
    INFO("turned by " << turn);
    CHECK(seeds_of(test::seen_samples(can(0.035, 0.1, false), X_CB)).empty());
  }
}

TEST_CASE("the lid of a can makes a seed of it, of which the mantle is a side", "[boxes][seeds]") {
  // That this side bends is seen by its points, of which seeds know nothing.
  const Eigen::Isometry3d X_CB =
      test::translation(0, 0, 0.6) * Eigen::AngleAxisd(0.9, -Eigen::Vector3d::UnitX());
  const SurfaceSamples samples = test::seen_samples(can(0.04, 0.06, true), X_CB);
  CHECK(seeds_of(samples).size() <= 1);
}

TEST_CASE("samples that are not free, few, none or not finite make no seed", "[boxes][seeds]") {
  CHECK(find_box_seeds({}, {}, {}).empty());
  const test::OrientedPoints box = test::sides_of_box(kSize);
  SurfaceSamples samples = test::seen_samples(box, test::showing_three_sides());
  CHECK(find_box_seeds(samples, Mask(samples.p.size(), 0), {}).empty());
  const auto tiny = test::sides_of_box(Eigen::Vector3d::Constant(3.0 * test::kSampleCell));
  CHECK(seeds_of(test::seen_samples(tiny, test::showing_three_sides())).empty());
  for (Eigen::Vector3f& n : samples.n) {
    n.setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  CHECK(seeds_of(samples).empty());
}

TEST_CASE("no more than sixteen pieces are looked at, the largest", "[boxes][seeds]") {
  test::OrientedPoints all;
  for (int k = 0; k < 20; ++k) {
    const Eigen::Vector3d side = Eigen::Vector3d::Constant((k < 4 ? 6 : 8) * test::kSampleCell);
    test::OrientedPoints box = test::sides_of_box(side);
    const int column = k % 5, row = k / 5;
    for (Eigen::Vector3d& p : box.p) {
      all.p.push_back(p + Eigen::Vector3d(0.06 * column, 0.06 * row, 0.0));
    }
    all.n.insert(all.n.end(), box.n.begin(), box.n.end());
  }
  const Eigen::Isometry3d X_CB = test::translation(0.15, 0.15, 0.5);
  const auto seeds = seeds_of(test::seen_samples(all, X_CB));
  CHECK(seeds.size() == 16);
  for (const BoxSeed& seed : seeds) {
    for (const FlatPatch& flat : seed) CHECK(flat.patch.half.maxCoeff() > 0.012);
  }
}

}  // namespace
}  // namespace quadrille

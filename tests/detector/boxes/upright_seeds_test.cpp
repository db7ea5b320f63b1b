#include "boxes/upright_seeds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "box_samples.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

/// A frame before the eye, seen from 35° above its level; y points up.
Eigen::Isometry3d standing_before_eye(double turn) {
  return test::translation(0.03, 0.0, 0.6) *
         Eigen::AngleAxisd(0.6 - M_PI, Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY());
}

std::optional<BoxSeed> seed_of_all(const SurfaceSamples& samples, const Eigen::Isometry3d& X_CB) {
  std::vector<int> all(samples.p.size());
  std::iota(all.begin(), all.end(), 0);
  return upright_seed(samples, all, X_CB.linear().col(1));
}

TEST_CASE("an upright box is found at any turn from where its samples lie, whatever their normals",
          "[boxes][seeds]") {
  const Eigen::Vector3d size(0.056, 0.084, 0.024);
  for (int k = 0; k < 12; ++k) {
    const Eigen::Isometry3d X_CB = standing_before_eye(0.13 + 0.26 * k);
    const SurfaceSamples samples = test::seen_samples(test::sides_of_box(size), X_CB, 0.6);
    const auto seed = seed_of_all(samples, X_CB);
    INFO("turn " << k);
    REQUIRE(seed);
    CHECK(seed->size() >= 2);
    for (const FlatPatch& flat : *seed) {
      const Eigen::Isometry3d X_BP = X_CB.inverse() * flat.patch.X_CP;
      Eigen::Index axis = 0;
      CHECK(X_BP.linear().col(2).cwiseAbs().maxCoeff(&axis) > std::cos(0.03));
      const double side = std::copysign(0.5 * size[axis], X_BP.linear()(axis, 2));
      CHECK(X_BP.translation()[axis] == Approx(side).margin(0.001));
    }
  }
}

TEST_CASE("balls and cans make no upright box, small ones and noisy ones neither",
          "[boxes][seeds]") {
  const Eigen::Isometry3d X_CB = standing_before_eye(0.0);
  for (const double radius : {0.02, 0.04}) {
    test::OrientedPoints ball, can;
    for (int k = 0; k < 2000; ++k) {
      const double y = 1.0 - (2.0 * k + 1.0) / 2000.0, angle = k * M_PI * (3.0 - std::sqrt(5.0));
      const Eigen::Vector3d around(std::cos(angle), 0.0, std::sin(angle));
      ball.n.emplace_back(std::sqrt(1.0 - y * y) * around + y * Eigen::Vector3d::UnitY());
      ball.p.push_back(radius * ball.n.back());
      can.n.push_back(around);
      can.p.emplace_back(radius * (around + 1.2 * y * Eigen::Vector3d::UnitY()));
    }
    for (const float sigma : {0.0005f, 0.001f}) {
      INFO("radius " << radius << ", noise " << sigma);
      for (const test::OrientedPoints* thing : {&ball, &can}) {
        SurfaceSamples samples = test::seen_samples(*thing, X_CB);
        std::fill(samples.sigma.begin(), samples.sigma.end(), sigma);
        CHECK_FALSE(seed_of_all(samples, X_CB));
      }
    }
  }
}

TEST_CASE("no samples, and samples that are not finite, make no upright box",
          "[boxes][seeds][hostile]") {
  const Eigen::Isometry3d X_CB = standing_before_eye(0.4);
  CHECK_FALSE(seed_of_all({}, X_CB));
  const auto box = test::sides_of_box({0.05, 0.05, 0.05});
  SurfaceSamples samples = test::seen_samples(box, X_CB);
  for (Eigen::Vector3f& p : samples.raw) p.setConstant(std::numeric_limits<float>::quiet_NaN());
  CHECK_FALSE(seed_of_all(samples, X_CB));
}

}  // namespace
}  // namespace quadrille

#include "lab/scene/pose_error.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::scene;

TEST_CASE("errors of poses have the size that was asked for, between whole seconds too",
          "[scene][path]") {
  constexpr PoseErrorSize kSize = {0.004, 0.01};
  constexpr int kSeconds = 4000;
  Random random(1, 0);
  const PoseError error(kSize, kSeconds, &random);
  for (const double share : {0.0, 0.5}) {
    double shift = 0.0, turn = 0.0;
    for (int i = 0; i < kSeconds; ++i) {
      const Eigen::Isometry3d X = error.at(i + share);
      const Eigen::AngleAxisd R(X.linear());
      shift += X.translation().squaredNorm();
      turn += R.angle() * R.angle();
    }
    // Each has three axes.
    CHECK(std::sqrt(shift / (3 * kSeconds)) == Approx(kSize.shift).epsilon(0.05));
    CHECK(std::sqrt(turn / (3 * kSeconds)) == Approx(kSize.turn).epsilon(0.05));
  }
}

TEST_CASE("errors of poses vary slowly, and are constant before and after the motion",
          "[scene][path]") {
  constexpr double kStep = 0.01, kDuration = 5.0;
  Random random(2, 0);
  const PoseError error({0.01, 0.0}, kDuration, &random);
  double most = 0.0, all = 0.0;
  for (double t = 0.0; t < kDuration; t += kStep) {
    const double step = (error.at(t + kStep).translation() - error.at(t).translation()).norm();
    most = std::max(most, step);
    all += step;
  }
  CHECK(most < 0.002);
  CHECK(all > 0.02);
  CHECK(error.at(-1.0).isApprox(error.at(0.0), 0.0));
  CHECK(error.at(kDuration + 1.0).isApprox(error.at(kDuration), 0.0));
}

TEST_CASE("poses without an error stay as they are", "[scene][path]") {
  Random random(3, 0);
  const PoseError error({}, 2.0, &random);
  CHECK(error.at(0.7).matrix() == Eigen::Matrix4d::Identity());
}

#include <array>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "quadrille/detector/detection.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

namespace quadrille {
namespace {

/// Poses of all kinds, among them such whose quaternions have equal or vanishing components.
std::vector<Eigen::Isometry3d> many_poses() {
  RandomStream random(11, 0);
  std::vector<Eigen::Isometry3d> poses;
  const std::array<double, 7> components = {-1.0, 0.0, 1.0, 1e-14, 1.0 + 1e-14, 1e-9, 0.5};
  for (int n = 0; n < 7 * 7 * 7 * 7; ++n) {
    const Eigen::Quaterniond q(components[n % 7], components[n / 7 % 7], components[n / 49 % 7],
                               components[n / 343]);
    if (q.norm() > 0.0) poses.emplace_back(q.normalized());
  }
  for (int n = 0; n < 20000; ++n) {
    poses.push_back(test::random_pose(random, 1.0) * test::random_pose(random, 1.0));
  }
  return poses;
}

TEST_CASE("rounded poses are hardly turned, and rounding them again changes no bit", "[frames]") {
  double turned = 0.0;
  bool kept = true, written = true, placed = true;
  for (const Eigen::Isometry3d& X : many_poses()) {
    const Eigen::Isometry3d once = rounded(X);
    turned = std::max(turned, (once.linear() - X.linear()).norm());
    kept = kept && rounded(once).matrix() == once.matrix();
    written = written && rotation_of(once).normalized().toRotationMatrix() == once.linear();
    placed = placed && once.translation() == X.translation();
  }
  CHECK(turned < 1e-12);
  CHECK(kept);
  CHECK(written);
  CHECK(placed);
}

TEST_CASE("a rotation is stored as the quaternion with w of at least 0", "[frames]") {
  for (const Eigen::Isometry3d& X : many_poses()) {
    const Eigen::Quaterniond R = rotation_of(X);
    REQUIRE(R.w() >= 0.0);
    REQUIRE(std::abs(R.norm() - 1.0) < 1e-15);
  }
}

}  // namespace
}  // namespace quadrille

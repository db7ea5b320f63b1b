#include <algorithm>
#include <cmath>

#include "quadrille/detector/detector.hpp"
#include "rounded_patches.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

// The sides behind the edges are round, so that no face is found there.
const Eigen::Vector3d kSize(0.1, 0.03, 0.12);
constexpr double kRadius = 0.012;

void add_to(std::vector<test::Patch>* all, const std::vector<test::Patch>& some) {
  all->insert(all->end(), some.begin(), some.end());
}

Eigen::Isometry3d turned(double yaw) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
}

PointCloud seen(const std::vector<test::Patch>& patches, double noise = 0.0005) {
  return test::render(patches, {640, 480, 1.0 / 600.0, noise});
}

/// The scene of a box with round edges that stands on a table.
std::vector<test::Patch> box_on_table(const Eigen::Isometry3d& X_CW, const Eigen::Isometry3d& X_WB) {
  std::vector<test::Patch> patches = test::rounded_box(X_CW * X_WB, kSize, kRadius);
  patches.push_back(test::rectangle(X_CW, 1.5, 1.2));
  return patches;
}

/// Compares a box with the true one, along the axes of the true one.
void check_size(const Box& box, const Eigen::Isometry3d& X_CB) {
  const Eigen::Matrix3d turn = (box.X_CB.linear().transpose() * X_CB.linear()).cwiseAbs();
  CHECK(turn.colwise().maxCoeff().minCoeff() > 0.99);
  const Eigen::Vector3d truth = turn.array().round().matrix() * kSize;
  for (int i = 0; i < 3; ++i) {
    INFO("side " << i << " of " << box.size.transpose() << ", truly " << truth.transpose());
    CHECK(box.seen[i] == (std::abs(truth[i] - kSize.y()) > 1e-6));
    CHECK(std::abs(box.size[i] - truth[i]) < (box.seen[i] ? 0.005 : 0.015));
    CHECK(box.outer_B.sizes()[i] > truth[i] - 0.004);
    CHECK(box.inner_B.sizes()[i] < truth[i] + 0.004);
  }
}

TEST_CASE("one upright face makes a box whose depth is said to be a guess", "[boxes]") {
  for (const double distance : {0.5, 0.7, 0.9}) {
    for (const double yaw : {-0.4, 0.0, 0.2, 0.5}) {
      const Eigen::Isometry3d X_CW =
          test::world_seen_from(distance * Eigen::Vector3d(0.0, -0.8, 0.6));
      const Eigen::Isometry3d X_WB = test::translation(0, 0, 0.5 * kSize.z()) * turned(yaw);
      const DetectionResult result = detect(seen(box_on_table(X_CW, X_WB)));
      INFO("at " << distance << ", turned by " << yaw);
      REQUIRE(result.boxes.size() == 1);
      CHECK(result.boxes[0].faces.size() == 1);
      check_size(result.boxes[0], X_CW * X_WB);
    }
  }
}

}  // namespace
}  // namespace quadrille

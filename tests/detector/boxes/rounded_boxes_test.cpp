#include <algorithm>
#include <cmath>

#include "quadrille/detector/detector.hpp"
#include "rounded_patches.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

TEST_CASE("a box with rounded edges is as large as it is, not as its flat parts", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.5, 0.45});
  const Eigen::Vector3d size(0.14, 0.07, 0.09);
  for (const double radius : {0.006, 0.01}) {
    for (const double yaw : {0.4, 0.8, 1.2, 2.0, 2.5}) {
      const Eigen::Isometry3d X_CB =
          X_CW * test::translation(0, 0, 0.5 * size.z()) *
          Eigen::Isometry3d(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
      std::vector<test::Patch> patches = test::rounded_box(X_CB, size, radius);
      patches.push_back(test::rectangle(X_CW, 1.5, 1.2));
      const DetectionResult result = detect(test::render(patches, {640, 480, 1.0 / 600.0, 0.0005}));
      INFO("radius " << radius << ", turned by " << yaw);
      REQUIRE(result.boxes.size() == 1);
      const Box& box = result.boxes[0];
      const Eigen::Matrix3d turn = (box.X_CB.linear().transpose() * X_CB.linear()).cwiseAbs();
      const Eigen::Vector3d error = box.size - turn.array().round().matrix() * size;
      INFO("error " << 1000.0 * error.transpose() << " mm");
      CHECK(error.cwiseAbs().maxCoeff() < 0.004);
    }
  }
}

TEST_CASE("a small box with rounded edges and bulging faces is found with its size", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.5, 0.45});
  constexpr double kShare = 0.03, kRadius = 0.007;
  const Eigen::Vector3d size(0.085, 0.032, 0.07);
  // The opposite faces of each axis bulge by a share of their own shorter sides.
  const Eigen::Vector3d inner = size - Eigen::Vector3d::Constant(2.0 * kRadius);
  Eigen::Vector3d whole = size;
  for (int axis = 0; axis < 3; ++axis) {
    whole[axis] += 2.0 * kShare * std::min(inner[(axis + 1) % 3], inner[(axis + 2) % 3]);
  }
  int found = 0;
  for (const double yaw : {0.4, 0.8, 1.2, 2.0, 2.5}) {
    const Eigen::Isometry3d X_CB =
        X_CW * test::translation(0, 0, 0.5 * size.z()) *
        Eigen::Isometry3d(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
    std::vector<test::Patch> patches = test::rounded_box(X_CB, size, kRadius, kShare);
    patches.push_back(test::rectangle(X_CW, 1.5, 1.2));
    const DetectionResult result = detect(test::render(patches, {640, 480, 1.0 / 600.0, 0.0003}));
    INFO("turned by " << yaw);
    for (const Box& box : result.boxes) {
      ++found;
      const Eigen::Matrix3d turn = (box.X_CB.linear().transpose() * X_CB.linear()).cwiseAbs();
      const Eigen::Vector3d truth = turn.array().round().matrix() * whole;
      const Eigen::Vector3d error = box.size - truth;
      INFO("error " << 1000.0 * error.transpose() << " mm");
      CHECK(error.cwiseAbs().maxCoeff() < 0.003);
      // The hidden side likely bulges as the seen one does. The box that was seen leaves that out.
      CHECK((box.inner_B.sizes() - truth).maxCoeff() < 0.0005);
    }
  }
  CHECK(found == 5);
}

}  // namespace
}  // namespace quadrille

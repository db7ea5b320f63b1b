#include <algorithm>
#include <cmath>

#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

/// A face of a box that bulges: the part of a sphere above a rectangle in the plane z = 0, through
/// its corners.
/// @param share  height of its middle over the rectangle, as a share of the shorter side; 0 for a
///               flat face
test::Patch bulging_face(const Eigen::Isometry3d& X_CP, double width, double height, double share) {
  if (share == 0.0) return test::rectangle(X_CP, width, height);
  const double bulge = share * std::min(width, height);
  const double half_diagonal = 0.5 * std::hypot(width, height);
  const double radius = (half_diagonal * half_diagonal + bulge * bulge) / (2.0 * bulge);
  test::Patch face = test::sphere(X_CP * test::translation(0, 0, bulge - radius), radius);
  face.box_B = {Eigen::Vector3d(-0.5 * width, -0.5 * height, 0.0),
                Eigen::Vector3d(0.5 * width, 0.5 * height, radius)};
  return face;
}

/// A box of which each edge is a quarter of a cylinder and each corner an eighth of a sphere.
std::vector<test::Patch> rounded_box(const Eigen::Isometry3d& X_CB, const Eigen::Vector3d& size,
                                     double radius, double share = 0.0) {
  const Eigen::Vector3d inner = size - Eigen::Vector3d::Constant(2.0 * radius);
  std::vector<test::Patch> patches;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Eigen::Isometry3d X_BA = Eigen::Isometry3d::Identity();
    X_BA.linear() << Eigen::Vector3d::Unit(u), Eigen::Vector3d::Unit(v),
        Eigen::Vector3d::Unit(axis);
    for (const double side : {-0.5, 0.5}) {
      const Eigen::Isometry3d turn(
          Eigen::AngleAxisd(side < 0.0 ? M_PI : 0.0, Eigen::Vector3d::UnitX()));
      patches.push_back(
          bulging_face(X_CB * X_BA * test::translation(0, 0, side * size[axis]) * turn, inner[u],
                       inner[v], share));
      for (const double other : {-0.5, 0.5}) {
        patches.push_back(
            test::mantle(X_CB * X_BA * test::translation(side * inner[u], other * inner[v], 0),
                         radius, inner[axis]));
        const double third = axis == 0 ? -0.5 : 0.5;
        if (axis == 2) continue;
        const Eigen::Vector3d corner(third * inner[0], side * inner[1], other * inner[2]);
        patches.push_back(test::sphere(X_CB * Eigen::Translation3d(corner), radius));
      }
    }
  }
  return patches;
}

TEST_CASE("a box with rounded edges is as large as it is, not as its flat parts", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.5, 0.45});
  const Eigen::Vector3d size(0.14, 0.07, 0.09);
  for (const double radius : {0.006, 0.01}) {
    for (const double yaw : {0.4, 0.8, 1.2, 2.0, 2.5}) {
      const Eigen::Isometry3d X_CB =
          X_CW * test::translation(0, 0, 0.5 * size.z()) *
          Eigen::Isometry3d(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
      std::vector<test::Patch> patches = rounded_box(X_CB, size, radius);
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
  int found = 0;
  for (const double yaw : {0.4, 0.8, 1.2, 2.0, 2.5}) {
    const Eigen::Isometry3d X_CB =
        X_CW * test::translation(0, 0, 0.5 * size.z()) *
        Eigen::Isometry3d(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
    std::vector<test::Patch> patches = rounded_box(X_CB, size, kRadius, kShare);
    patches.push_back(test::rectangle(X_CW, 1.5, 1.2));
    const DetectionResult result = detect(test::render(patches, {640, 480, 1.0 / 600.0, 0.0003}));
    INFO("turned by " << yaw);
    for (const Box& box : result.boxes) {
      ++found;
      const Eigen::Matrix3d turn = (box.X_CB.linear().transpose() * X_CB.linear()).cwiseAbs();
      const Eigen::Vector3d error = box.size - turn.array().round().matrix() * size;
      INFO("error " << 1000.0 * error.transpose() << " mm");
      CHECK(error.cwiseAbs().maxCoeff() < 0.004);
    }
  }
  CHECK(found == 5);
}

}  // namespace
}  // namespace quadrille

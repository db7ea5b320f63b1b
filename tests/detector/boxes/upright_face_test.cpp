#include <algorithm>
#include <cmath>

#include "../table_scene.hpp"
#include "quadrille/detector/detector.hpp"
#include "rounded_patches.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

// The sides behind the edges are round, so that no face is found there.
const Eigen::Vector3d kSize(0.1, 0.028, 0.12);
constexpr double kRadius = 0.0139;

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
std::vector<test::Patch> box_on_table(const Eigen::Isometry3d& X_CW,
                                      const Eigen::Isometry3d& X_WB) {
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
    CHECK(std::abs(box.size[i] - truth[i]) < (box.seen[i] ? 0.006 : 0.015));
    CHECK(box.outer_B.sizes()[i] > truth[i] - 0.004);
    CHECK(box.inner_B.sizes()[i] < truth[i] + 0.006);
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

TEST_CASE("a box of one upright face is the same for any number of threads",
          "[boxes][determinism]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.56, 0.42});
  const PointCloud cloud =
      seen(box_on_table(X_CW, test::translation(0, 0, 0.5 * kSize.z()) * turned(0.2)));
  DetectorOptions options;
  options.threads = 1;
  const std::vector<Box> one = detect(cloud, options).boxes;
  options.threads = 2;
  const std::vector<Box> two = detect(cloud, options).boxes;
  REQUIRE(one.size() == 1);
  REQUIRE(two.size() == 1);
  REQUIRE(one[0].faces.size() == 1);
  CHECK(two[0].faces == one[0].faces);
  CHECK(two[0].X_CB.matrix() == one[0].X_CB.matrix());
  CHECK(two[0].size == one[0].size);
  CHECK(two[0].std == one[0].std);
  CHECK(two[0].seen == one[0].seen);
  CHECK(two[0].inner_B.min() == one[0].inner_B.min());
  CHECK(two[0].outer_B.max() == one[0].outer_B.max());
}

TEST_CASE("the foot of an upright face that another box hides is bounded by the table", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.6, 0.4});
  const Eigen::Isometry3d X_CB = X_CW * test::translation(0, 0, 0.5 * kSize.z()) * turned(0.2);
  std::vector<test::Patch> patches = test::rounded_box(X_CB, kSize, kRadius);
  patches.push_back(test::rectangle(X_CW, 1.5, 1.2));
  const Eigen::Vector3d low(0.3, 0.06, 0.06);
  add_to(&patches, test::box(X_CW * test::translation(0, -0.12, 0.5 * low.z()), low));
  const DetectionResult result = detect(seen(patches));
  const auto found = std::find_if(result.boxes.begin(), result.boxes.end(), [&](const Box& box) {
    return (box.X_CB.translation() - X_CB.translation()).norm() < 0.03;
  });
  REQUIRE(found != result.boxes.end());
  const Eigen::Matrix3d turn = (found->X_CB.linear().transpose() * X_CB.linear()).cwiseAbs();
  const Eigen::Vector3d truth = turn.array().round().matrix() * kSize;
  for (int i = 0; i < 3; ++i) {
    CHECK(found->seen[i] == (truth[i] == Approx(kSize.x())));
    CHECK(found->outer_B.sizes()[i] > truth[i] - 0.004);
    if (truth[i] != Approx(kSize.y())) CHECK(std::abs(found->size[i] - truth[i]) < 0.006);
  }
}

TEST_CASE("what is open at the top is no solid, however it is seen", "[boxes]") {
  for (const double elevation : {0.3, 0.5, 0.8, 1.0}) {
    for (const double yaw : {0.0, 0.3, 0.7}) {
      const Eigen::Isometry3d X_CW = test::world_seen_from(
          0.8 * Eigen::Vector3d(0.0, -std::cos(elevation), std::sin(elevation)));
      std::vector<test::Patch> patches =
          test::box(X_CW * test::translation(0, 0, 0.06) * turned(yaw), {0.25, 0.2, 0.12});
      patches.pop_back();
      patches.push_back(test::rectangle(X_CW, 1.2, 1.0));
      INFO("from " << elevation << " above, turned by " << yaw);
      CHECK(detect(seen(patches)).boxes.empty());
    }
  }
}

TEST_CASE("neither a screen nor a wall is a box", "[boxes]") {
  const Eigen::Vector3d screen(0.28, 0.005, 0.18), wall(0.5, 0.1, 0.4);
  for (const Eigen::Vector3d& size : {screen, wall}) {
    for (const double elevation : {0.3, 0.6}) {
      for (const double yaw : {0.0, 0.3}) {
        const Eigen::Isometry3d X_CW =
            test::world_seen_from(Eigen::Vector3d(0.0, -std::cos(elevation), std::sin(elevation)));
        std::vector<test::Patch> patches = test::rounded_box(
            X_CW * test::translation(0, 0, 0.5 * size.z()) * turned(yaw), size, 0.4 * size.y());
        patches.push_back(test::rectangle(X_CW, 1.5, 1.5));
        INFO(size.transpose() << " from " << elevation << " above, turned by " << yaw);
        CHECK(detect(seen(patches)).boxes.empty());
      }
    }
  }
}

TEST_CASE("the front of a cylinder is no face of a box", "[boxes]") {
  for (const double radius : {0.03, 0.06, 0.1}) {
    for (const double distance : {0.6, 1.0}) {
      for (const double noise : {0.0005, 0.002}) {
        const Eigen::Isometry3d X_CW =
            test::world_seen_from(distance * Eigen::Vector3d(0.0, -0.8, 0.6));
        std::vector<test::Patch> patches =
            test::can(X_CW * test::translation(0, 0, 0.07), radius, 0.14);
        patches.push_back(test::rectangle(X_CW, 1.5, 1.5));
        INFO("radius " << radius << " at " << distance);
        CHECK(detect(seen(patches, noise)).boxes.empty());
      }
    }
  }
}

TEST_CASE("a moved cloud gives the moved box of one face", "[boxes][law]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.72, 0.54});
  const PointCloud cloud =
      seen(box_on_table(X_CW, test::translation(0, 0, 0.5 * kSize.z()) * turned(0.2)));
  std::vector<Detection> detections = detect(cloud).detections;
  const std::vector<Box> here = find_boxes(cloud, detections);
  REQUIRE(here.size() == 1);
  for (const double angle : {0.8, 2.0, -1.5}) {
    const Eigen::Isometry3d X(Eigen::Translation3d(0.4, -0.2, 0.3) *
                              Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -1).normalized()));
    std::vector<Detection> moved = detections;
    for (Detection& d : moved) {
      d.X_CQ = X * d.X_CQ;
      d.Q_C = d.Q_C.transformed(X);
    }
    const std::vector<Box> there = find_boxes(test::moved_cloud(cloud, X), moved);
    REQUIRE(there.size() == 1);
    CHECK(there[0].seen == here[0].seen);
    CHECK((there[0].size - here[0].size).norm() < 4e-3);
    CHECK((there[0].X_CB.translation() - X * here[0].X_CB.translation()).norm() < 2e-3);
  }
}

}  // namespace
}  // namespace quadrille

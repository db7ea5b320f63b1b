// A scene that lasts: what several views show together, what stays while it is hidden, what goes.
#include "quadrille/detector/lasting_detector.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "detector/table_scene.hpp"
#include "detector/views/taken_views.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/options.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

const Eigen::Vector3d kCan_W(0.2, 0.0, 0.5 * kCanLength);

Taken seen_from(double degrees, const std::vector<Patch>& patches = world_table()) {
  return taken_from_eye(patches, eye_at(degrees), 0.001, 320);
}

DetectionResult add_view(LastingDetector& detector, double seconds, const Taken& view) {
  DetectionResult result =
      detector.detect(static_cast<std::int64_t>(seconds * kSecond), view.cloud, view.X_WK);
  result.detections = moved(std::move(result.detections), view.X_WK);
  result.boxes = moved(std::move(result.boxes), view.X_WK);
  result.bodies = moved(std::move(result.bodies), view.X_WK);
  return result;
}

/// The ball, within a centimetre of where it is.
const Detection* ball_of(const DetectionResult& in_world) {
  for (const Detection& d : in_world.detections) {
    const bool is_ball = d.type == QuadricType::kSphere || d.type == QuadricType::kEllipsoid;
    if (is_ball && (d.X_CQ.translation() - kBall_W).norm() < 0.01) return &d;
  }
  return nullptr;
}

const Detection* can_of(const DetectionResult& in_world) {
  for (const Detection& d : in_world.detections) {
    const Eigen::Vector3d from = d.X_CQ.translation() - kCan_W;
    if (d.type == QuadricType::kCylinder && from.head<2>().norm() < 0.01) return &d;
  }
  return nullptr;
}

const SceneBody* body_of(const DetectionResult& result, int part) {
  for (const SceneBody& body : result.bodies) {
    if (std::find(body.parts.begin(), body.parts.end(), part) != body.parts.end()) return &body;
  }
  return nullptr;
}

const Box* box_near(const DetectionResult& in_world, const Eigen::Vector3d& middle_W) {
  for (const Box& box : in_world.boxes) {
    if ((box.X_CB.translation() - middle_W).norm() < 0.02) return &box;
  }
  return nullptr;
}

/// A wall in front of the ball, as a camera at this angle sees it.
std::vector<Patch> with_screen(double degrees) {
  std::vector<Patch> patches = world_table();
  const Eigen::Vector3d towards = (eye_at(degrees) - kBall_W).normalized();
  const Eigen::Isometry3d X_WS =
      Eigen::Translation3d(kBall_W + 0.15 * towards) *
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), towards);
  patches.push_back(rectangle(X_WS, 0.16, 0.16));
  return patches;
}

}  // namespace

TEST_CASE("the first view of a scene gives the bits of detect()", "[views][lasting]") {
  LastingDetector detector;
  const Taken view = seen_from(0);
  const DetectionResult lasting = detector.detect(kSecond, view.cloud, view.X_WK);
  CHECK(numbers(lasting) == numbers(detect(view.cloud)));
  CHECK(detector.size() == 1);
  for (const SceneBody& body : lasting.bodies) {
    CHECK(body.views == 1);
    CHECK(body.unseen == 0.0);
  }
}

TEST_CASE("views from all sides show more of a thing than one, and measure it better",
          "[views][lasting]") {
  LastingDetector detector;
  const DetectionResult one = add_view(detector, 1, seen_from(0));
  add_view(detector, 2, seen_from(120));
  const DetectionResult all = add_view(detector, 3, seen_from(240));
  CHECK(detector.size() == 3);
  const Detection *ball = ball_of(all), *single = ball_of(one);
  REQUIRE(ball != nullptr);
  REQUIRE(single != nullptr);
  CHECK(ball->type == QuadricType::kSphere);
  // Seen from one side, a ball shows less than half of itself.
  CHECK(ball->extent_Q.sizes().minCoeff() > 1.5 * kBall);
  CHECK(single->extent_Q.sizes().minCoeff() < ball->extent_Q.sizes().minCoeff());
  CHECK(dimension(*ball, "radius") == Approx(kBall).margin(0.0005));
  const Detection* whole_can = can_of(all);
  REQUIRE(whole_can != nullptr);
  CHECK(whole_can->seen > 0.8);
  CHECK(dimension(*whole_can, "radius") == Approx(kCan).margin(0.0005));
  const SceneBody* body = body_of(all, whole_can->id);
  REQUIRE(body != nullptr);
  CHECK(body->views == 3);
  CHECK(body->unseen == 0.0);
}

TEST_CASE("a hidden thing stays, and its body says for how long it was not seen",
          "[views][lasting]") {
  LastingDetector detector;
  add_view(detector, 1, seen_from(0, with_screen(60)));
  const Taken hidden = seen_from(60, with_screen(60));
  const DetectionResult alone = detect(hidden.cloud);
  const DetectionResult without = [&] {
    DetectionResult result = alone;
    result.detections = moved(std::move(result.detections), hidden.X_WK);
    return result;
  }();
  REQUIRE(ball_of(without) == nullptr);
  const DetectionResult lasting = add_view(detector, 3.5, hidden);
  const Detection* ball = ball_of(lasting);
  REQUIRE(ball != nullptr);
  CHECK(dimension(*ball, "radius") == Approx(kBall).margin(0.001));
  const SceneBody* body = body_of(lasting, ball->id);
  REQUIRE(body != nullptr);
  CHECK(body->views == 1);
  CHECK(body->unseen == Approx(2.5));
}

TEST_CASE("a thing that was taken away is found no longer", "[views][lasting]") {
  LastingDetector detector;
  add_view(detector, 1, seen_from(0));
  add_view(detector, 2, seen_from(60));
  REQUIRE(ball_of(add_view(detector, 3, seen_from(120))) != nullptr);
  const DetectionResult after = add_view(detector, 4, seen_from(180, world_without_ball()));
  for (const Detection& d : after.detections) {
    if (d.type == QuadricType::kPlane) continue;
    CHECK((d.X_CQ.translation() - kBall_W).norm() > 0.1);
  }
  CHECK(can_of(after) != nullptr);
}

TEST_CASE(
    "nothing is found of a bowl that was taken away, though its bottom lay close to the table",
    "[views][lasting]") {
  Patch bowl = sphere(Eigen::Isometry3d(Eigen::Translation3d(kBall_W)), kBall);
  bowl.box_B.max().z() = -0.4 * kBall;
  std::vector<Patch> with_bowl = world_without_ball();
  with_bowl.push_back(bowl);
  LastingDetector detector;
  for (int n = 0; n < 3; ++n) add_view(detector, 1.0 + n, seen_from(40.0 * n, with_bowl));
  const auto count_near = [](const DetectionResult& in_world) {
    return std::count_if(in_world.bodies.begin(), in_world.bodies.end(), [](const SceneBody& body) {
      return (body.X_CB.translation() - kBall_W).norm() < 0.1;
    });
  };
  REQUIRE(count_near(add_view(detector, 4, seen_from(120, with_bowl))) > 0);
  add_view(detector, 5, seen_from(20, world_without_ball()));
  CHECK(count_near(add_view(detector, 6, seen_from(100, world_without_ball()))) == 0);
}

TEST_CASE("a thing that was put down is found at once", "[views][lasting]") {
  LastingDetector detector;
  add_view(detector, 1, seen_from(0, world_without_ball()));
  add_view(detector, 2, seen_from(60, world_without_ball()));
  const DetectionResult after = add_view(detector, 3, seen_from(120));
  const Detection* ball = ball_of(after);
  REQUIRE(ball != nullptr);
  CHECK(ball->score > 0.7);
  CHECK(can_of(after) != nullptr);
}

TEST_CASE("a box stays while it is hidden, with the sides that were seen", "[views][lasting]") {
  const TableScene scene;
  const Eigen::Isometry3d X_WB = scene.X_CW.inverse() * scene.X_CBox;
  LastingDetector detector;
  const DetectionResult before = add_view(detector, 1, seen_from(0));
  const Box* seen = box_near(before, X_WB.translation());
  REQUIRE(seen != nullptr);
  // A wall between the camera and the box.
  std::vector<Patch> patches = world_table();
  const Eigen::Vector3d towards = (eye_at(180) - X_WB.translation()).normalized();
  patches.push_back(
      rectangle(Eigen::Translation3d(X_WB.translation() + 0.2 * towards) *
                    Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), towards),
                0.3, 0.3));
  const DetectionResult hidden = add_view(detector, 2, seen_from(180, patches));
  const Box* box = box_near(hidden, X_WB.translation());
  REQUIRE(box != nullptr);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(box->size[axis] == Approx(seen->size[axis]).margin(0.003));
  }
  int last = 0;
  for (const Detection& d : hidden.detections) last = std::max(last, d.id);
  CHECK(box->id > last);
}

TEST_CASE("errors of poses are corrected before views are joined", "[views][lasting]") {
  LastingDetector detector;
  add_view(detector, 1, seen_from(0));
  Taken off = seen_from(120);
  off.X_WK = Eigen::Translation3d(0.002, -0.001, 0.0015) * off.X_WK;
  const DetectionResult all = add_view(detector, 2, off);
  const Detection* ball = ball_of(all);
  REQUIRE(ball != nullptr);
  CHECK(dimension(*ball, "radius") == Approx(kBall).margin(0.0008));
}

TEST_CASE("a lasting scene far from the frame's origin is found alike", "[views][lasting]") {
  const Eigen::Isometry3d X_CK(Eigen::Translation3d(3000.0, -2000.0, 100.0));
  LastingDetector near, far;
  DetectionResult here, there;
  for (const int k : {0, 1}) {
    const Taken view = seen_from(120 * k);
    here = near.detect(kSecond * (k + 1), view.cloud, view.X_WK);
    there = far.detect(kSecond * (k + 1), moved(view.cloud, X_CK), view.X_WK * X_CK.inverse());
  }
  there.detections = moved(std::move(there.detections), X_CK.inverse());
  // Points so far away are known to a quarter of a millimetre.
  const std::vector<const Detection*> a = curved(here), b = curved(there);
  REQUIRE(a.size() == b.size());
  for (const Detection* d : a) {
    const bool found = std::any_of(b.begin(), b.end(), [&](const Detection* other) {
      return other->type == d->type &&
             (other->X_CQ.translation() - d->X_CQ.translation()).norm() < 0.003;
    });
    CHECK(found);
  }
  CHECK(here.boxes.size() == there.boxes.size());
}

TEST_CASE("the same views give the same bits for any number of threads", "[views][lasting]") {
  const auto numbers_of = [](int threads) {
    DetectorOptions options;
    options.threads = threads;
    LastingDetector detector(options);
    std::vector<double> all;
    for (const int k : {0, 1, 2}) {
      const Taken view = seen_from(70 * k);
      const std::vector<double> some = numbers(detector.detect(k * kSecond, view.cloud, view.X_WK));
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  };
  const std::vector<double> one = numbers_of(1);
  CHECK(one == numbers_of(1));
  CHECK(one == numbers_of(2));
}

TEST_CASE("what is forgotten is found no longer while it is hidden", "[views][lasting]") {
  const Taken hidden = seen_from(60, with_screen(60));
  LastingDetector detector;
  add_view(detector, 1, seen_from(0, with_screen(60)));

  SECTION("everything") {
    detector.forget();
    CHECK(detector.size() == 0);
  }
  SECTION("a box about the ball") {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(kBall + 0.01);
    detector.forget(Eigen::Isometry3d(Eigen::Translation3d(kBall_W)), {-half, half});
    CHECK(detector.size() == 1);
  }
  SECTION("with time") {
    DetectorOptions options;
    options.views.remember = 1.0;
    detector = LastingDetector(options);
    add_view(detector, 1, seen_from(0, with_screen(60)));
  }
  CHECK(ball_of(add_view(detector, 3, hidden)) == nullptr);
}

TEST_CASE("an empty cloud and bad options do no harm to a lasting scene", "[views][lasting]") {
  DetectorOptions bad;
  bad.views.most = 0;
  CHECK_THROWS_AS(LastingDetector(bad), std::invalid_argument);
  LastingDetector detector;
  add_view(detector, 1, seen_from(0));
  CHECK_FALSE(
      detector.detect(2 * kSecond, PointCloud{}, Eigen::Isometry3d::Identity()).warnings.empty());
  PointCloud invalid = seen_from(60).cloud;
  for (Eigen::Vector3f& p : invalid.points) p.setConstant(std::numeric_limits<float>::quiet_NaN());
  CHECK(detector.detect(3 * kSecond, invalid, Eigen::Isometry3d::Identity()).points_used == 0);
  CHECK(detector.size() == 1);
  CHECK(ball_of(add_view(detector, 4, seen_from(60))) != nullptr);
}

TEST_CASE("a cloud that shows nothing gives what other views showed, and since when it is unseen",
          "[views][lasting]") {
  LastingDetector detector;
  add_view(detector, 1, seen_from(0));
  const DetectionResult both = add_view(detector, 2, seen_from(120));
  PointCloud nothing;
  const Taken from_aside = seen_from(120);
  if (GENERATE(true, false)) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    nothing = from_aside.cloud;
    for (Eigen::Vector3f& p : nothing.points) p.setConstant(nan);
  }
  const DetectionResult later = add_view(detector, 5, {nothing, from_aside.X_WK});
  REQUIRE(ball_of(later) != nullptr);
  REQUIRE(can_of(later) != nullptr);
  CHECK(later.detections.size() == both.detections.size());
  CHECK(later.points_used == 0);
  CHECK(later.warnings.front() ==
        "this cloud shows nothing: the result is what 2 others showed, the newest 3.00 s before");
  const SceneBody* ball = body_of(later, ball_of(later)->id);
  REQUIRE(ball != nullptr);
  CHECK(ball->views == 2);
  CHECK(ball->unseen == Approx(3.0));
  // The views stay as they were.
  CHECK(detector.size() == 2);
  CHECK(ball_of(add_view(detector, 6, seen_from(240))) != nullptr);
  detector.forget();
  CHECK(add_view(detector, 7, {nothing, from_aside.X_WK}).detections.empty());
}

TEST_CASE("a map's frame kilometres away does not spoil what is remembered", "[views][lasting]") {
  const Eigen::Vector3d far(3000.0, -2000.0, 0.0);
  LastingDetector near, distant;
  const Taken view = seen_from(0);
  const auto in_frame = [&](PointCloud cloud, const Eigen::Vector3d& shift) {
    return moved(std::move(cloud), Eigen::Translation3d(shift) * view.X_WK);
  };
  PointCloud nothing;
  for (const auto& [detector, shift] :
       {std::pair(&near, Eigen::Vector3d(0, 0, 0)), std::pair(&distant, far)}) {
    detector->detect(kSecond, in_frame(view.cloud, shift), Eigen::Isometry3d::Identity());
  }
  const DetectionResult here =
      near.detect(2 * kSecond, in_frame(nothing, {0, 0, 0}), Eigen::Isometry3d::Identity());
  DetectionResult there =
      distant.detect(2 * kSecond, in_frame(nothing, far), Eigen::Isometry3d::Identity());
  there.detections =
      moved(std::move(there.detections), Eigen::Isometry3d(Eigen::Translation3d(-far)));
  REQUIRE(ball_of(here) != nullptr);
  REQUIRE(ball_of(there) != nullptr);
  CHECK((ball_of(here)->X_CQ.translation() - ball_of(there)->X_CQ.translation()).norm() < 1e-3);
}

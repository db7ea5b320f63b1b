#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "detector/table_scene.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Places round the table, the first one that of table_cloud().
const std::vector<Eigen::Vector3d> kEyes = {
    {0.0, -0.8, 0.65}, {0.75, 0.1, 0.7}, {-0.6, 0.55, 0.65}};

Eigen::Isometry3d pose_in_first(const Eigen::Vector3d& eye) {
  return world_seen_from(kEyes.front()) * world_seen_from(eye).inverse();
}

/// Renders the patches for a camera at the eye. The patches and the cloud are in the frame of the
/// first view.
PointCloud view_of(std::vector<Patch> patches, const Eigen::Vector3d& eye, double noise) {
  const Eigen::Isometry3d X_CV = pose_in_first(eye);
  for (Patch& patch : patches) patch.X_CB = X_CV.inverse() * patch.X_CB;
  Camera camera;
  camera.noise = noise;
  return moved_cloud(render(patches, camera), X_CV);
}

std::vector<PointCloud> table_views(double noise = 0.001) {
  std::vector<PointCloud> views;
  for (const Eigen::Vector3d& eye : kEyes) {
    views.push_back(view_of(TableScene().patches(), eye, noise));
  }
  return views;
}

/// A turn about the camera and a shift, as a calibration is off.
Eigen::Isometry3d pose_error(const Eigen::Vector3d& eye_C, const Eigen::Vector3d& turn,
                             const Eigen::Vector3d& shift) {
  return Eigen::Translation3d(eye_C + shift) * Eigen::AngleAxisd(turn.norm(), turn.normalized()) *
         Eigen::Translation3d(-eye_C);
}

std::size_t count_finite(const PointCloud& cloud) {
  return static_cast<std::size_t>(
      std::count_if(cloud.points.begin(), cloud.points.end(),
                    [](const Eigen::Vector3f& p) { return p.allFinite(); }));
}

double std_of(const Detection& detection, const std::string& name) {
  for (const Dimension& d : detection.dimensions) {
    if (d.name == name) return d.std;
  }
  return NAN;
}

}  // namespace

TEST_CASE("views whose poses are off are brought onto each other", "[views]") {
  std::vector<PointCloud> views = table_views();
  const Eigen::Isometry3d error =
      pose_error(views[1].viewpoint, {0.003, -0.002, 0.001}, {0.002, -0.003, 0.001});
  views[1] = moved_cloud(views[1], error);
  const std::vector<Eigen::Isometry3d> motions = align_views(&views);
  REQUIRE(motions.size() == 3);
  CHECK(motions[0].matrix().isIdentity(0.0));
  // In the middle of the scene the view was some 4 mm off.
  const Eigen::Vector3d middle = TableScene().X_CW.translation();
  CHECK((error * middle - middle).norm() > 0.003);
  const Eigen::Isometry3d rest = motions[1] * error;
  CHECK((rest * middle - middle).norm() < 0.001);
  CHECK(Eigen::AngleAxisd(rest.linear()).angle() < 0.0015);
  CHECK((motions[2] * middle - middle).norm() < 0.001);
}

TEST_CASE("along a bare table views stay where their poses say", "[views]") {
  std::vector<PointCloud> views;
  const Eigen::Isometry3d X_CW = world_seen_from(kEyes.front());
  for (const Eigen::Vector3d& eye : kEyes) {
    views.push_back(view_of({rectangle(X_CW, 1.2, 0.9)}, eye, 0.0005));
  }
  const Eigen::Vector3d up = X_CW.linear().col(2);
  views[1] = moved_cloud(views[1], Eigen::Isometry3d(Eigen::Translation3d(0.004 * up)));
  const Eigen::Isometry3d motion = align_views(&views)[1];
  const Eigen::Vector3d shift = motion * X_CW.translation() - X_CW.translation();
  CHECK(shift.dot(up) == Approx(-0.004).margin(0.0007));
  // A turn about the camera explains a part of the shift, and moves the view along the table.
  CHECK((shift - shift.dot(up) * up).norm() < 0.001);
}

TEST_CASE("poses that are to be trusted are not corrected", "[views]") {
  std::vector<PointCloud> views = table_views();
  views[1] = moved_cloud(views[1], Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.003)));
  DetectorOptions options;
  options.views.shift = options.views.turn = 0.0;
  std::vector<PointCloud> trusted = views;
  for (const Eigen::Isometry3d& motion : align_views(&trusted, options)) {
    CHECK(motion.matrix().isIdentity(0.0));
  }
  // Directions alone may be trusted.
  options.views.shift = 0.002;
  const Eigen::Isometry3d motion = align_views(&views, options)[1];
  CHECK(Eigen::AngleAxisd(motion.linear()).angle() < 1e-6);
  CHECK(motion.translation().norm() > 0.001);
}

TEST_CASE("a view of something else, or without a viewpoint, stays where it is and drops nothing",
          "[views]") {
  std::vector<PointCloud> views = table_views();
  const bool elsewhere = GENERATE(true, false);
  if (elsewhere) {
    views[1] = moved_cloud(views[1], Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, -0.3)));
  } else {
    views[1].viewpoint.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  const std::size_t before = count_finite(views[0]);
  CHECK(align_views(&views)[1].matrix().isIdentity(0.0));
  CHECK(count_finite(views[0]) >= before - before / 500);
  CHECK(count_finite(views[1]) > 0);
}

TEST_CASE("what other views see through is dropped, and nothing else", "[views]") {
  std::vector<PointCloud> views = table_views();
  // A false patch in the air above the table, in the first view alone.
  std::vector<Patch> patches = TableScene().patches();
  patches.push_back(rectangle(TableScene().X_CW * translation(0.1, 0.0, 0.25), 0.1, 0.1));
  views[0] = view_of(patches, kEyes[0], 0.001);
  const Eigen::Isometry3d X_WC = TableScene().X_CW.inverse();
  const auto in_the_air = [&](const PointCloud& cloud) {
    return std::count_if(cloud.points.begin(), cloud.points.end(), [&](const Eigen::Vector3f& p) {
      return p.allFinite() && (X_WC * p.cast<double>()).z() > 0.2;
    });
  };
  const auto before = in_the_air(views[0]);
  REQUIRE(before > 300);
  std::vector<std::size_t> all;
  for (const PointCloud& view : views) all.push_back(count_finite(view));
  align_views(&views);
  CHECK(in_the_air(views[0]) == 0);
  CHECK(count_finite(views[0]) >= all[0] - static_cast<std::size_t>(before) - all[0] / 500);
  CHECK(count_finite(views[1]) >= all[1] - all[1] / 500);
  CHECK(count_finite(views[2]) >= all[2] - all[2] / 500);
}

TEST_CASE("what one view alone shows on the table, and others see to be bare, is no lump",
          "[views]") {
  // Stereo sensors lift parts of a table by a centimetre or two, which is no more than poses and
  // depths may be off, so that the points stay.
  std::vector<Patch> patches = TableScene().patches();
  const Eigen::Vector3d place(0.05, -0.25, 0.0);
  for (int n = 0; n < 6; ++n) {
    const Eigen::Vector3d at = place + Eigen::Vector3d(0.03 * (n % 3), n < 3 ? 0.0 : 0.03, 0.0);
    patches.push_back(sphere(TableScene().X_CW * Eigen::Isometry3d(Eigen::Translation3d(at)),
                             0.018 + 0.002 * (n % 3)));
  }
  const Eigen::Isometry3d X_WC = TableScene().X_CW.inverse();
  const auto lumps = [&](const DetectionResult& result) {
    return std::count_if(result.bodies.begin(), result.bodies.end(), [&](const SceneBody& body) {
      const Eigen::Vector3d aside = X_WC * body.X_CB.translation() - place;
      return body.kind == BodyKind::kLump && aside.norm() < 0.12;
    });
  };
  std::vector<PointCloud> views = table_views();
  views[0] = view_of(patches, kEyes[0], 0.001);
  REQUIRE(lumps(detect(views[0])) > 0);
  align_views(&views);
  CHECK(lumps(detect_views(views)) == 0);
}

TEST_CASE("of several views each thing is found once, with the sides that any view shows",
          "[views]") {
  std::vector<PointCloud> views = table_views();
  views[1] = moved_cloud(
      views[1], pose_error(views[1].viewpoint, {0.002, 0.001, -0.001}, {0.001, 0.001, -0.001}));
  align_views(&views);
  const DetectionResult one = table_result(), all = detect_views(views);
  check_sound(all);
  CHECK(all.warnings.empty());
  CHECK(curved(all).size() == 2);
  const TableScene scene;
  const Detection* ball = find(all, QuadricType::kSphere);
  REQUIRE(ball);
  CHECK(dimension(*ball, "radius") == Approx(kBall).epsilon(0.01));
  CHECK((ball->X_CQ.translation() - scene.p_CBall).norm() < 0.0015);
  const Detection* of_one = find(one, QuadricType::kCylinder);
  const Detection* of_all = find(all, QuadricType::kCylinder);
  REQUIRE(of_one);
  REQUIRE(of_all);
  CHECK(of_all->seen > 1.6 * of_one->seen);
  CHECK(dimension(*of_all, "radius") == Approx(kCan).margin(0.001));
  CHECK(std::abs(dimension(*of_all, "radius") - kCan) < 2.0 * std_of(*of_all, "radius"));
  CHECK(of_all->inliers > 2 * of_one->inliers);
  REQUIRE(all.boxes.size() == 1);
  CHECK(std::all_of(all.boxes.front().seen.begin(), all.boxes.front().seen.end(),
                    [](bool seen) { return seen; }));
  Eigen::Vector3d sizes = scene.box_size;
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  CHECK((all.boxes.front().size - sizes).cwiseAbs().maxCoeff() < 0.006);
  CHECK(std::none_of(all.bodies.begin(), all.bodies.end(),
                     [](const SceneBody& body) { return body.kind == BodyKind::kLump; }));
}

TEST_CASE("the result of views depends neither on threads nor on a distant origin", "[views]") {
  std::vector<PointCloud> views = table_views();
  DetectorOptions two;
  two.threads = 2;
  CHECK(numbers(detect_views(views)) == numbers(detect_views(views, two)));
  const Eigen::Vector3d shift(40.0, -20.0, 8.0);
  std::vector<PointCloud> far;
  for (const PointCloud& view : views) {
    far.push_back(moved_cloud(view, Eigen::Isometry3d(Eigen::Translation3d(shift))));
  }
  const DetectionResult there = detect_views(far);
  CHECK(curved(there).size() == 2);
  const Detection* ball = find(there, QuadricType::kSphere);
  REQUIRE(ball);
  CHECK((ball->X_CQ.translation() - shift - TableScene().p_CBall).norm() < 0.002);
}

TEST_CASE("a single view gives what detect() gives", "[views]") {
  const std::vector<PointCloud> view = {table_cloud()};
  CHECK(numbers(detect_views(view)) == numbers(table_result()));
  std::vector<PointCloud> same = view;
  CHECK(align_views(&same).front().matrix().isIdentity(0.0));
  CHECK(same.front().points.size() == view.front().points.size());
}

TEST_CASE("views that show nothing are left out and said to be", "[views]") {
  CHECK_THROWS_AS(detect_views({}), std::invalid_argument);
  std::vector<PointCloud> views = {table_cloud(), PointCloud()};
  CHECK(align_views(&views)[1].matrix().isIdentity(0.0));
  const DetectionResult result = detect_views(views);
  CHECK(warns(result, "view 2: "));
  CHECK(curved(result).size() == 2);
}

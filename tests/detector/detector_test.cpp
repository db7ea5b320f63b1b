#include "quadrille/detector/detector.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "detector/table_scene.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("on a table a ball, a can and the table are found, and nothing curved on the box",
          "[detector]") {
  const TableScene scene;
  const DetectionResult& result = table_result();
  check_sound(result);
  CHECK(result.warnings.empty());
  CHECK(curved(result).size() == 2);

  const Detection* ball = find(result, QuadricType::kSphere);
  REQUIRE(ball);
  CHECK(dimension(*ball, "radius") == Approx(kBall).epsilon(0.02));
  CHECK((ball->X_CQ.translation() - scene.p_CBall).norm() < 0.003);

  const Detection* cylinder = find(result, QuadricType::kCylinder);
  REQUIRE(cylinder);
  CHECK(dimension(*cylinder, "radius") == Approx(kCan).epsilon(0.03));
  CHECK(dimension(*cylinder, "length") == Approx(kCanLength).margin(0.02));
  const Eigen::Vector3d axis = scene.X_CCan.linear().col(2);
  CHECK(std::abs(cylinder->X_CQ.linear().col(2).dot(axis)) > std::cos(0.05));
  const Eigen::Vector3d off = cylinder->X_CQ.translation() - scene.X_CCan.translation();
  CHECK(off.cross(axis).norm() < 0.004);
  CHECK(std::abs(off.dot(axis)) < 0.015);
}

TEST_CASE("planes are detections: the table and the top of the box", "[detector]") {
  const TableScene scene;
  const Eigen::Vector3d up = scene.X_CW.linear().col(2);
  const auto has_plane = [&](const Eigen::Vector3d& p, double width, double height) {
    const auto& list = table_result().detections;
    return std::any_of(list.begin(), list.end(), [&](const Detection& d) {
      return d.type == QuadricType::kPlane && d.X_CQ.linear().col(2).dot(up) > std::cos(0.02) &&
             std::abs(up.dot(d.X_CQ.translation() - p)) < 0.002 &&
             std::abs(dimension(d, "width") - width) < 0.04 &&
             std::abs(dimension(d, "height") - height) < 0.04;
    });
  };
  CHECK(has_plane(scene.X_CW.translation(), 1.2, 0.9));
  CHECK(has_plane(scene.X_CBox * Eigen::Vector3d(0, 0, 0.05), 0.14, 0.12));
}

TEST_CASE("an upright face of the box is a plane, small as it is", "[detector]") {
  const TableScene scene;
  const auto& list = table_result().detections;
  CHECK(std::any_of(list.begin(), list.end(), [&](const Detection& d) {
    const Eigen::Vector3d normal_B = scene.X_CBox.linear().transpose() * d.X_CQ.linear().col(2);
    const Eigen::Vector3d p_B = scene.X_CBox.inverse() * d.X_CQ.translation();
    return d.type == QuadricType::kPlane && normal_B.head<2>().cwiseAbs().maxCoeff() > 0.99 &&
           p_B.cwiseAbs().maxCoeff() < 0.08;
  }));
}

TEST_CASE("gradients point to the side that the camera saw", "[detector]") {
  for (const Detection& d : table_result().detections) {
    const Eigen::Vector3d centre = d.X_CQ.translation();
    // A point of the surface towards the camera: its first-order foot from a little before it.
    const double reach = d.type == QuadricType::kPlane ? 0.0 : dimension(d, "radius");
    const Eigen::Vector3d x = centre - reach * centre.normalized();
    CHECK(d.Q_C.gradient(x).dot(-x) > 0);
  }
}

TEST_CASE("a moved cloud with its moved viewpoint gives the moved quadrics", "[detector][law]") {
  const DetectionResult& here = table_result();
  Eigen::Isometry3d turned = translation(1.0, -2.0, 0.5);
  turned.rotate(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, -2, 0.5).normalized()));
  for (const Eigen::Isometry3d& X : {translation(0.3, 0.2, -0.4), turned}) {
    const DetectionResult there = detect(moved_cloud(table_cloud(), X));
    check_sound(there);
    REQUIRE(curved(there).size() == curved(here).size());
    for (const QuadricType type : {QuadricType::kSphere, QuadricType::kCylinder}) {
      const Detection *a = find(here, type), *b = find(there, type);
      REQUIRE(b);
      CHECK(dimension(*b, "radius") == Approx(dimension(*a, "radius")).epsilon(0.02));
      const Eigen::Vector3d p = X * a->X_CQ.translation();
      CHECK((b->X_CQ.translation() - p).norm() < 0.01);
      if (type == QuadricType::kCylinder) {
        const Eigen::Vector3d axis = X.linear() * a->X_CQ.linear().col(2);
        CHECK(b->X_CQ.linear().col(2).dot(axis) > std::cos(0.05));
      }
    }
  }
}

TEST_CASE("the result has the same bits for 1, 2, 5 and 8 threads, and each time",
          "[detector][determinism]") {
  const std::vector<double> once = numbers(table_result());
  for (const int threads : {1, 2, 5, 8}) {
    DetectorOptions options;
    options.threads = threads;
    CHECK(numbers(detect(table_cloud(), options)) == once);
  }
}

TEST_CASE("only the wanted types are reported", "[detector]") {
  DetectorOptions options;
  options.only = {QuadricType::kCylinder};
  const DetectionResult result = detect(table_cloud(), options);
  REQUIRE(result.detections.size() == 1);
  CHECK(result.detections[0].type == QuadricType::kCylinder);
  CHECK(result.detections[0].id == 1);
  options.only = {QuadricType::kCone};
  CHECK(detect(table_cloud(), options).detections.empty());
}

TEST_CASE("what is not to be reported is found all the same, and marked by its id", "[detector]") {
  const DetectionResult all = detect(table_cloud());
  DetectorOptions options;
  options.report = {QuadricType::kCylinder};
  const DetectionResult some = detect(table_cloud(), options);
  REQUIRE(some.detections.size() == all.detections.size());
  std::set<std::vector<double>> quadrics, marked;
  const auto numbers_of = [](const Detection& d) {
    const Vector10d q = d.Q_C.coefficients();
    return std::vector<double>(q.data(), q.data() + q.size());
  };
  for (const Detection& d : all.detections) quadrics.insert(numbers_of(d));
  int reported = 0, others = 0;
  for (const Detection& d : some.detections) {
    marked.insert(numbers_of(d));
    CHECK(is_reported(d) == (d.type == QuadricType::kCylinder));
    CHECK(d.id == (is_reported(d) ? ++reported : --others));
    // Those that were asked for come first.
    CHECK((others == 0 || !is_reported(d)));
  }
  CHECK(marked == quadrics);
  CHECK(reported == 1);
  CHECK(others < 0);
}

TEST_CASE("a bowl's inside is a sphere whose gradient points inwards", "[detector][law]") {
  // Half a sphere, open towards the camera.
  constexpr double kRadius = 0.1;
  Patch bowl = sphere(translation(0, 0, 0.8), kRadius);
  bowl.box_B.min().z() = 0.0;
  Camera camera;
  camera.noise = 0.0005;
  const DetectionResult inside =
      detect(render({rectangle(translation(0, 0, 0.95), 2, 2), bowl}, camera));
  const Detection* found = find(inside, QuadricType::kSphere);
  REQUIRE(found);
  CHECK(dimension(*found, "radius") == Approx(kRadius).epsilon(0.03));
  CHECK(found->Q_C.gradient({0, 0, 0.9}).z() < 0);

  const DetectionResult outside = detect(render(
      {rectangle(translation(0, 0, 0.95), 2, 2), sphere(translation(0, 0, 0.8), kRadius)}, camera));
  found = find(outside, QuadricType::kSphere);
  REQUIRE(found);
  CHECK(found->Q_C.gradient({0, 0, 0.7}).z() < 0);
  CHECK(found->X_CQ.translation().z() == Approx(0.8).margin(0.004));
}

TEST_CASE("a sphere is found in a cloud from all sides", "[detector][voxel]") {
  constexpr double kRadius = 0.06;
  PointCloud cloud;
  RandomStream random(121, 0);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d n =
        Eigen::Vector3d(gaussian(random), gaussian(random), gaussian(random)).normalized();
    const Eigen::Vector3d x = (kRadius + 0.0003 * gaussian(random)) * n;
    cloud.points.push_back((Eigen::Vector3d(0.2, 0.1, 0) + x).cast<float>());
  }
  cloud.viewpoint = {0.2, 0.1, 0.5};
  const DetectionResult result = detect(cloud);
  check_sound(result);
  const Detection* ball = find(result, QuadricType::kSphere);
  REQUIRE(ball);
  CHECK(curved(result).size() == 1);
  CHECK(dimension(*ball, "radius") == Approx(kRadius).epsilon(0.02));
  CHECK((ball->X_CQ.translation() - Eigen::Vector3d(0.2, 0.1, 0)).norm() < 0.002);
  CHECK(ball->seen > 0.9);
}

TEST_CASE("cells as a share of the cloud see the same in millimetres", "[detector][voxel]") {
  PointCloud cloud;
  RandomStream random(122, 0);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d n =
        Eigen::Vector3d(gaussian(random), gaussian(random), gaussian(random)).normalized();
    cloud.points.push_back((0.0625 * n).cast<float>());
  }
  PointCloud large = cloud;
  for (Eigen::Vector3f& p : large.points) p *= 64.0f;
  DetectorOptions options;
  options.sampling.relative_cell = 0.03;
  // The diagonal of the box about a ball is √3 of its diameter.
  DetectorOptions same;
  same.sampling.cell = 0.03 * std::sqrt(3.0) * 0.125;
  const Detection* ball = find(detect(cloud, options), QuadricType::kSphere);
  REQUIRE(ball);
  const DetectionResult in_metres = detect(cloud, same), enlarged = detect(large, options);
  REQUIRE(find(in_metres, QuadricType::kSphere));
  REQUIRE(find(enlarged, QuadricType::kSphere));
  CHECK(dimension(*find(enlarged, QuadricType::kSphere), "radius") == Approx(4.0).epsilon(0.01));
  CHECK(detect(cloud, options).points_used == detect(cloud, same).points_used);
  // By the default, a cell of 3 mm, the large ball is too sparse to be seen.
  CHECK_FALSE(find(detect(large), QuadricType::kSphere));
}

TEST_CASE("the stages' times add up to no more than the total", "[detector]") {
  double sum = 0;
  for (const StageTime& stage : table_result().timings) {
    CHECK(stage.ms >= 0.0);
    sum += stage.ms;
  }
  CHECK(table_result().timings.size() >= 4);
  CHECK(sum <= table_result().total_ms * 1.001);
}

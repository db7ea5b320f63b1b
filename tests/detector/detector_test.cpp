#include "quadrille/detector/detector.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kBall = 0.06, kCan = 0.045, kCanLength = 0.16;

/// A table with a ball, a can and a box, seen from 1 m away, 40° from above.
struct TableScene {
  Eigen::Isometry3d X_CW = world_seen_from({0.0, -0.8, 0.65});
  Eigen::Vector3d p_CBall = X_CW * Eigen::Vector3d(-0.2, 0.0, kBall);
  Eigen::Isometry3d X_CCan = X_CW * translation(0.2, 0.0, 0.5 * kCanLength);
  Eigen::Isometry3d X_CBox = X_CW * translation(0.0, 0.1, 0.05) *
                             Eigen::Isometry3d(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()));
  Eigen::Vector3d box_size{0.14, 0.12, 0.1};

  std::vector<Patch> patches() const {
    std::vector<Patch> all = {rectangle(X_CW, 1.2, 0.9),
                              sphere(Eigen::Isometry3d(Eigen::Translation3d(p_CBall)), kBall)};
    for (const Patch& p : can(X_CCan, kCan, kCanLength)) all.push_back(p);
    for (const Patch& p : box(X_CBox, box_size)) all.push_back(p);
    return all;
  }
};

const PointCloud& table_cloud() {
  static const PointCloud cloud = [] {
    Camera camera;
    camera.noise = 0.001;
    return render(TableScene().patches(), camera);
  }();
  return cloud;
}

const DetectionResult& table_result() {
  static const DetectionResult result = detect(table_cloud());
  return result;
}

double dimension(const Detection& detection, const std::string& name) {
  for (const Dimension& d : detection.dimensions) {
    if (d.name == name) return d.value;
  }
  return NAN;
}

const Detection* find(const DetectionResult& result, QuadricType type) {
  for (const Detection& d : result.detections) {
    if (d.type == type) return &d;
  }
  return nullptr;
}

std::vector<const Detection*> curved(const DetectionResult& result) {
  std::vector<const Detection*> list;
  for (const Detection& d : result.detections) {
    if (!is_flat(d.type)) list.push_back(&d);
  }
  return list;
}

void check_sound(const DetectionResult& result) {
  int id = 0;
  double last = 1e300;
  for (const Detection& d : result.detections) {
    CHECK(d.id == ++id);
    CHECK(d.score <= last);
    last = d.score;
    CHECK(d.score >= 0.0);
    CHECK(d.score <= 1.0);
    CHECK(d.Q_C.coefficients().norm() == Approx(1.0));
    CHECK(d.X_CQ.matrix().allFinite());
    CHECK(d.X_CQ.linear().determinant() == Approx(1.0));
    CHECK(d.inliers > 0);
    CHECK(d.rms >= 0.0);
    CHECK(d.seen > 0.0);
    CHECK(d.seen <= 1.0);
    CHECK_FALSE(d.extent_Q.isEmpty());
    for (const Dimension& dimension : d.dimensions) {
      CHECK(std::isfinite(dimension.value));
      CHECK(std::isfinite(dimension.std));
      CHECK(dimension.value > 0.0);
    }
  }
  CHECK(result.points_used <= result.points_finite);
}

/// All numbers of a result but the times.
std::vector<double> numbers(const DetectionResult& result) {
  std::vector<double> list;
  const auto add = [&](const auto& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) list.push_back(matrix.data()[i]);
  };
  for (const Detection& d : result.detections) {
    list.insert(list.end(), {static_cast<double>(d.id), static_cast<double>(d.type), d.score,
                             static_cast<double>(d.inliers), d.rms, d.seen});
    add(d.Q_C.matrix());
    add(d.X_CQ.matrix());
    add(d.extent_Q.min());
    add(d.extent_Q.max());
    for (const Dimension& dimension : d.dimensions) {
      list.push_back(dimension.value);
      list.push_back(dimension.std);
    }
  }
  list.push_back(static_cast<double>(result.points_used));
  return list;
}

PointCloud moved_cloud(PointCloud cloud, const Eigen::Isometry3d& X) {
  for (Eigen::Vector3f& p : cloud.points) p = (X * p.cast<double>()).cast<float>();
  cloud.viewpoint = X * cloud.viewpoint;
  return cloud;
}

bool warns(const DetectionResult& result, const std::string& text) {
  return std::any_of(result.warnings.begin(), result.warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

}  // namespace

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

TEST_CASE("the result has the same bits for 1, 2 and 5 threads, and each time",
          "[detector][determinism]") {
  const std::vector<double> once = numbers(table_result());
  for (const int threads : {1, 2, 5}) {
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

TEST_CASE("the order and the doubling of points change no finding", "[detector][law]") {
  PointCloud doubled = table_cloud();
  doubled.width = doubled.height = 0;
  std::erase_if(doubled.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  const std::vector<Eigen::Vector3f> once = doubled.points;
  doubled.points.insert(doubled.points.end(), once.begin(), once.end());
  const DetectionResult result = detect(doubled);
  check_sound(result);
  CHECK(result.points_finite == 2 * once.size());
  for (const QuadricType type : {QuadricType::kSphere, QuadricType::kCylinder}) {
    const Detection* d = find(result, type);
    REQUIRE(d);
    CHECK(dimension(*d, "radius") ==
          Approx(dimension(*find(table_result(), type), "radius")).epsilon(0.03));
  }
}

TEST_CASE("missing points change no finding", "[detector][hostile]") {
  PointCloud holed = table_cloud();
  RandomStream random(122, 0);
  std::size_t finite = 0;
  for (Eigen::Vector3f& p : holed.points) {
    const double u = random.uniform();
    if (u < 0.03) p.x() = NAN;
    if (u > 0.97) p.z() = INFINITY;
    finite += p.allFinite();
  }
  const DetectionResult result = detect(holed);
  check_sound(result);
  CHECK(result.points_finite == finite);
  CHECK(find(result, QuadricType::kSphere));
  CHECK(find(result, QuadricType::kCylinder));
}

TEST_CASE("clouds without surfaces give nothing and say why", "[detector][degenerate]") {
  const auto refused = [](const std::vector<Eigen::Vector3f>& points, const std::string& why) {
    PointCloud cloud;
    cloud.points = points;
    const DetectionResult result = detect(cloud);
    CHECK(result.detections.empty());
    CAPTURE(why);
    CHECK(warns(result, why));
  };
  refused({}, "only 0 finite points");
  refused({{0.1f, 0.2f, 1.0f}}, "only 1 finite points");
  refused(std::vector<Eigen::Vector3f>(5000, Eigen::Vector3f::Constant(NAN)),
          "only 0 finite points");
  refused(std::vector<Eigen::Vector3f>(5000, Eigen::Vector3f(0.1f, 0.2f, 1.0f)), "coincide");
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 5000; ++i) line.push_back({1e-4f * static_cast<float>(i), 0.2f, 1.0f});
  refused(line, "line");
}

TEST_CASE("noise without surfaces has no curved quadrics", "[detector][degenerate]") {
  PointCloud cloud;
  RandomStream random(123, 0);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    cloud.points.push_back(Eigen::Vector3d(x - 0.5, y - 0.5, 0.5 + z).cast<float>());
  }
  const DetectionResult result = detect(cloud);
  check_sound(result);
  CHECK(curved(result).empty());
}

TEST_CASE("millimetres are warned about and give no quadric of NaN", "[detector][hostile]") {
  PointCloud cloud = table_cloud();
  for (Eigen::Vector3f& p : cloud.points) p *= 1000.0f;
  const DetectionResult result = detect(cloud);
  check_sound(result);
  CHECK(warns(result, "millimetres"));
}

TEST_CASE("an option out of range is refused by name", "[detector][hostile]") {
  DetectorOptions options;
  options.planes.sigmas = -1.0;
  CHECK_THROWS_AS(detect(table_cloud(), options), std::invalid_argument);
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

#include <cmath>
#include <stdexcept>

#include "detector/table_scene.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/missing_codes.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("points given twice, and as a list instead of an image, change no finding",
          "[detector][law]") {
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

TEST_CASE("a cloud far from the origin of its frame gives the same findings there",
          "[detector][law]") {
  for (const double far : {20.0, 1000.0}) {
    const Eigen::Vector3d shift(far, -0.5 * far, 0.25 * far);
    PointCloud moved = table_cloud();
    for (Eigen::Vector3f& p : moved.points) p += shift.cast<float>();
    moved.viewpoint = shift;
    const DetectionResult result = detect(moved);
    check_sound(result);
    for (const QuadricType type : {QuadricType::kSphere, QuadricType::kCylinder}) {
      const Detection *here = find(table_result(), type), *there = find(result, type);
      REQUIRE(there);
      CHECK(dimension(*there, "radius") == Approx(dimension(*here, "radius")).epsilon(0.02));
      const Eigen::Vector3d x_C = there->X_CQ.translation();
      CHECK((x_C - shift - here->X_CQ.translation()).norm() < 0.005);
      // The equation holds on the surface: a point of it one radius beside the axis.
      const Eigen::Vector3d side = there->X_CQ.linear().col(0);
      CHECK(std::abs(there->Q_C.distance(x_C + dimension(*there, "radius") * side)) < 1e-4);
    }
  }
}

TEST_CASE("one point far from all others changes no finding", "[detector][hostile]") {
  for (const float far : {1e3f, 1e19f, 3e38f}) {
    PointCloud cloud = table_cloud();
    cloud.points.front() = Eigen::Vector3f::Constant(far);
    const DetectionResult result = detect(cloud);
    check_sound(result);
    CHECK(find(result, QuadricType::kSphere));
    CHECK(find(result, QuadricType::kCylinder));
  }
}

TEST_CASE("pixels with codes for missing ones change no bit of the findings",
          "[detector][hostile]") {
  const PointCloud holed = with_gaps(table_cloud());
  const DetectionResult truth = detect(holed);
  REQUIRE_FALSE(truth.detections.empty());
  REQUIRE_FALSE(truth.boxes.empty());
  const std::vector<Box> true_boxes = find_boxes(holed, truth.detections);
  for (const float code : kMissingCodes) {
    CAPTURE(code);
    const PointCloud coded = with_code(table_cloud(), code);
    const DetectionResult result = detect(coded);
    CHECK(numbers(result) == numbers(truth));
    CHECK(result.points_finite == truth.points_finite);
    CHECK(result.warnings.size() == (std::isfinite(code) ? 1 : 0));
    CHECK(warns(result, "farther than 1 km") == std::isfinite(code));
    // Likewise for those who call parts of it.
    const std::vector<Box> boxes = find_boxes(coded, truth.detections);
    REQUIRE(boxes.size() == true_boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      CHECK(boxes[k].X_CB.matrix() == true_boxes[k].X_CB.matrix());
      CHECK(boxes[k].size == true_boxes[k].size);
    }
    CHECK(contradict_viewpoint(coded, truth.detections).empty());
  }
}

TEST_CASE("codes in a list of points, also of a map, change no bit of the findings",
          "[detector][hostile]") {
  for (const double far : {0.0, 1e4}) {
    const PointCloud cloud = moved_cloud(table_cloud(), translation(far, 0.0, 0.0));
    const DetectionResult truth = detect(as_list(with_gaps(cloud)));
    REQUIRE(find(truth, QuadricType::kSphere));
    for (const float code : {1e30f, -1e22f, std::numeric_limits<float>::max()}) {
      PointCloud coded = as_list(with_code(cloud, code));
      std::erase_if(coded.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
      CHECK(numbers(detect(coded)) == numbers(truth));
    }
  }
}

TEST_CASE("an option out of range is refused by name", "[detector][hostile]") {
  DetectorOptions options;
  options.planes.sigmas = -1.0;
  CHECK_THROWS_AS(detect(table_cloud(), options), std::invalid_argument);
}

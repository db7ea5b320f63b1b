#include <algorithm>
#include <cmath>
#include <vector>

#include "bodies/axial_part.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

using test::Patch;

const Eigen::Isometry3d& table() {
  static const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.6, 0.5});
  return X_CW;
}

void add(const std::vector<Patch>& some, std::vector<Patch>* all) {
  all->insert(all->end(), some.begin(), some.end());
}

DetectionResult seen(std::vector<Patch> patches, const DetectorOptions& options = {}) {
  patches.push_back(test::rectangle(table(), 1.4, 1.2));
  return detect(test::render(patches, {640, 480, 1.0 / 600.0, 0.0005}), options);
}

const SceneBody* find(const DetectionResult& result, BodyKind kind) {
  const auto found = std::find_if(result.bodies.begin(), result.bodies.end(),
                                  [&](const SceneBody& body) { return body.kind == kind; });
  return found == result.bodies.end() ? nullptr : &*found;
}

int table_id(const DetectionResult& result) {
  return std::max_element(
             result.detections.begin(), result.detections.end(),
             [](const Detection& a, const Detection& b) { return a.inliers < b.inliers; })
      ->id;
}

/// Height over the table [m].
double height(const Eigen::Vector3d& p_C) { return (table().inverse() * p_C).z(); }

/// A ring that no quadric explains: balls side by side along a bent line.
std::vector<Patch> knot(double x, double y) {
  std::vector<Patch> balls;
  for (int k = 0; k < 9; ++k) {
    const double bend = 0.012 * std::sin(2.1 * k);
    balls.push_back(test::sphere(
        table() * test::translation(x + 0.011 * k - 0.045, y + bend, 0.014 + 0.02 * (k % 3)),
        0.011 + 0.003 * (k % 2)));
  }
  return balls;
}

TEST_CASE("a can is one body with its lid, from the table to the top", "[bodies]") {
  const double radius = 0.04, length = 0.11;
  const DetectionResult result =
      seen(test::can(table() * test::translation(0.0, 0.0, 0.5 * length), radius, length));
  const SceneBody* body = find(result, BodyKind::kRevolution);
  REQUIRE(body != nullptr);
  CHECK(body->parts.size() == 2);
  CHECK(body->standing_on == table_id(result));
  CHECK(body->size.x() == Approx(2.0 * radius).margin(0.002));
  CHECK(body->size.y() == Approx(2.0 * radius).margin(0.002));
  CHECK(body->size.z() == Approx(length).margin(0.004));
  CHECK(body->seen == std::array<bool, 3>{true, true, true});
  CHECK(height(body->X_CB.translation()) == Approx(0.5 * length).margin(0.003));
  CHECK((table().linear().transpose() * body->X_CB.linear().col(2)).z() > 0.999);
  int points = 0;
  for (const Detection& d : result.detections) {
    const bool part = std::find(body->parts.begin(), body->parts.end(), d.id) != body->parts.end();
    if (part) points += d.inliers;
  }
  CHECK(body->points >= points);
}

TEST_CASE("the body and the neck of a bottle share an axis, two cans do not", "[bodies]") {
  const Eigen::Isometry3d X_CBottle = table() * test::translation(-0.1, 0.0, 0.0);
  std::vector<Patch> patches = {
      test::mantle(X_CBottle * test::translation(0, 0, 0.06), 0.035, 0.12),
      test::mantle(X_CBottle * test::translation(0, 0, 0.15), 0.018, 0.06)};
  add(test::can(table() * test::translation(0.12, 0.0, 0.05), 0.035, 0.1), &patches);
  const DetectionResult result = seen(patches);
  std::vector<std::size_t> sizes;
  for (const SceneBody& body : result.bodies) {
    if (body.kind == BodyKind::kRevolution) sizes.push_back(body.parts.size());
  }
  CHECK(sizes == std::vector<std::size_t>{2, 2});
}

TEST_CASE("a box is one body with its faces, and its number is that of the box", "[bodies]") {
  const Eigen::Vector3d size(0.12, 0.08, 0.06);
  const DetectionResult result =
      seen(test::box(table() * test::translation(0.0, 0.0, 0.5 * size.z()), size));
  REQUIRE(result.boxes.size() == 1);
  const SceneBody* body = find(result, BodyKind::kBox);
  REQUIRE(body != nullptr);
  CHECK(body->id == result.boxes[0].id);
  CHECK(body->parts == result.boxes[0].faces);
  CHECK(body->size == result.boxes[0].size);
  CHECK(body->standing_on == table_id(result));
}

TEST_CASE("what nothing explains is a lump on its support", "[bodies]") {
  const DetectionResult result = seen(knot(0.0, 0.05));
  std::size_t named = 0;
  for (const SceneBody& body : result.bodies) {
    const Eigen::Vector3d p_W = table().inverse() * body.X_CB.translation();
    CHECK(std::abs(p_W.x()) < 0.08);
    CHECK(std::abs(p_W.y() - 0.05) < 0.06);
    named += static_cast<std::size_t>(body.points);
    if (body.kind == BodyKind::kLump) CHECK(body.parts.empty());
  }
  // Its pixels: 0.13 m by 0.05 m seen at 0.78 m with 600 pixels a radian.
  CHECK(named > 1500);
}

TEST_CASE("bodies have numbers that name one thing each", "[bodies]") {
  std::vector<Patch> patches = knot(-0.15, 0.0);
  add(test::can(table() * test::translation(0.0, 0.0, 0.05), 0.03, 0.1), &patches);
  const Eigen::Vector3d size(0.1, 0.07, 0.08);
  add(test::box(table() * test::translation(0.16, 0.0, 0.04), size), &patches);
  const DetectionResult result = seen(patches);
  std::vector<int> ids, parts;
  for (const SceneBody& body : result.bodies) {
    ids.push_back(body.id);
    parts.insert(parts.end(), body.parts.begin(), body.parts.end());
    if (body.kind == BodyKind::kLump) {
      CHECK(body.id > static_cast<int>(result.detections.size() + result.boxes.size()));
    }
  }
  CHECK(std::is_sorted(ids.begin(), ids.end()));
  CHECK(std::adjacent_find(ids.begin(), ids.end()) == ids.end());
  std::sort(parts.begin(), parts.end());
  CHECK(std::adjacent_find(parts.begin(), parts.end()) == parts.end());
  CHECK(find(result, BodyKind::kRevolution) != nullptr);
  CHECK(find(result, BodyKind::kBox) != nullptr);

  // Whatever is reported, equal bodies keep their places.
  DetectorOptions only_curved;
  only_curved.report = {QuadricType::kCylinder};
  for (const SceneBody& body : seen(patches, only_curved).bodies) {
    CHECK(body.kind != BodyKind::kBox);
    for (const int id : body.parts) CHECK(id > 0);
  }
}

TEST_CASE("axes are shared by what lies around or along one axis", "[bodies]") {
  const auto cylinder = [](double x, double z, double radius) {
    AxialPart part;
    part.middle_C = {x, 0.0, z};
    part.axis_C = Eigen::Vector3d::UnitZ();
    part.radius = radius;
    part.half_length = 0.05;
    return part;
  };
  const AxialPart body = cylinder(0.0, 0.0, 0.04);
  CHECK(share_axis(body, cylinder(0.002, 0.0, 0.036)));
  CHECK(share_axis(body, cylinder(0.0, 0.11, 0.02)));
  CHECK_FALSE(share_axis(body, cylinder(0.02, 0.0, 0.04)));
  CHECK_FALSE(share_axis(body, cylinder(0.0, 0.3, 0.04)));
  AxialPart tilted = body;
  tilted.axis_C = Eigen::Vector3d(0.3, 0.0, 1.0).normalized();
  CHECK_FALSE(share_axis(body, tilted));
  AxialPart ball;
  ball.radius = ball.half_length = 0.04;
  ball.middle_C = {0.0, 0.0, 0.06};
  CHECK(share_axis(body, ball));
  CHECK(share_axis(ball, body));
  ball.middle_C.x() = 0.03;
  CHECK_FALSE(share_axis(ball, body));
}

}  // namespace
}  // namespace quadrille

#include <algorithm>
#include <limits>

#include "../table_scene.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

constexpr double kNoise = 0.001;

PointCloud cloud_of(const std::vector<test::Patch>& patches, double noise = kNoise) {
  test::Camera camera{640, 480, 1.0 / 600.0, noise};
  return test::render(patches, camera);
}

void append(const std::vector<test::Patch>& some, std::vector<test::Patch>* all) {
  all->insert(all->end(), some.begin(), some.end());
}

Eigen::Isometry3d standing(const Eigen::Vector3d& size, double x, double y, double yaw) {
  return test::translation(x, y, 0.5 * size.z()) *
         Eigen::Isometry3d(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
}

/// The true size along the axes of a box that has the true box's axes in any order.
Eigen::Vector3d size_along(const Box& box, const Eigen::Isometry3d& X_CB,
                           const Eigen::Vector3d& size) {
  const Eigen::Matrix3d turn = (box.X_CB.linear().transpose() * X_CB.linear()).cwiseAbs();
  CHECK(turn.colwise().maxCoeff().minCoeff() > 0.99);
  return turn.array().round().matrix() * size;
}

bool is_plane(const DetectionResult& result, int id) {
  return id >= 1 && id <= static_cast<int>(result.detections.size()) &&
         result.detections[id - 1].type == QuadricType::kPlane;
}

TEST_CASE("a box on a table is made of the planes that are its faces", "[boxes]") {
  const test::TableScene scene;
  const DetectionResult& result = test::table_result();
  REQUIRE(result.boxes.size() == 1);
  const Box& box = result.boxes[0];
  CHECK(box.id == static_cast<int>(result.detections.size()) + 1);
  CHECK(!box.faces.empty());
  for (const int id : box.faces) CHECK(is_plane(result, id));
  CHECK((box.X_CB.translation() - scene.X_CBox.translation()).norm() < 0.004);
  CHECK((box.size - size_along(box, scene.X_CBox, scene.box_size)).cwiseAbs().maxCoeff() < 0.004);
  CHECK(box.seen == std::array<bool, 3>{true, true, true});
  CHECK(box.X_CB.linear().determinant() == Approx(1.0));
  CHECK(box.size.x() >= box.size.y());
  CHECK(box.size.y() >= box.size.z());
}

TEST_CASE("boxes of all sizes and turns are found, as large as they are", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.7, 0.55});
  for (int k = 0; k < 12; ++k) {
    RandomStream random(5, static_cast<std::uint64_t>(k));
    const auto between = [&](double low, double high) {
      return low + (high - low) * random.uniform();
    };
    const Eigen::Vector3d size(between(0.06, 0.2), between(0.05, 0.15), between(0.04, 0.2));
    const Eigen::Isometry3d X_CB = X_CW * standing(size, between(-0.1, 0.1), 0.0, between(0, 3));
    std::vector<test::Patch> patches = {test::rectangle(X_CW, 1.5, 1.2)};
    append(test::box(X_CB, size), &patches);
    const PointCloud cloud = cloud_of(patches);
    const DetectionResult result = detect(cloud);
    INFO("box " << k << " of " << size.transpose());
    REQUIRE(result.boxes.size() == 1);
    const Box& box = result.boxes[0];
    const Eigen::Vector3d error = box.size - size_along(box, X_CB, size);
    CHECK((box.X_CB.translation() - X_CB.translation()).norm() < 0.005);
    for (int i = 0; i < 3; ++i) {
      CHECK(box.seen[i]);
      CHECK(std::abs(error[i]) < 0.004);
      CHECK(std::abs(error[i]) < 5.0 * box.std[i]);
    }
  }
}

TEST_CASE("no box is made of balls, cans, a table and a wall", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.8, 0.65});
  std::vector<test::Patch> patches = {
      test::rectangle(X_CW, 1.4, 1.0),
      test::rectangle(X_CW * test::translation(0, 0.5, 0) *
                          Eigen::Isometry3d(Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitX())),
                      3.0, 3.0),
      test::sphere(X_CW * test::translation(-0.2, 0, 0.06), 0.06)};
  append(test::can(X_CW * test::translation(0.2, 0, 0.08), 0.045, 0.16), &patches);
  append(test::can(X_CW * test::translation(0.0, 0.1, 0.03), 0.06, 0.06), &patches);
  for (const double noise : {0.0005, 0.001, 0.002}) {
    CHECK(detect(cloud_of(patches, noise)).boxes.empty());
  }
}

TEST_CASE("no box spans two boxes that stand side by side, one farther out", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.7, 0.55});
  const Eigen::Vector3d size(0.06, 0.1, 0.1);
  for (const double yaw : {0.2, 0.5}) {
    const Eigen::Isometry3d X_CB = X_CW * standing(size, 0.0, 0.0, yaw);
    std::vector<test::Patch> patches = {test::rectangle(X_CW, 1.5, 1.2)};
    for (const int k : {-1, 0, 1}) {
      append(test::box(X_CB * test::translation(0.06 * k, 0.02 * k, 0.0), size), &patches);
    }
    const std::vector<Box> boxes = detect(cloud_of(patches)).boxes;
    CHECK(!boxes.empty());
    for (const Box& box : boxes) CHECK(box.size.maxCoeff() < 0.105);
  }
}

TEST_CASE("the corner of a room is no box", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.7, 0.7, 0.6});
  const std::vector<test::Patch> walls = test::box(X_CW, {0.6, 0.6, 0.6});
  // The far faces of a hollow cube.
  CHECK(detect(cloud_of({walls[0], walls[2], walls[4]})).boxes.empty());
}

TEST_CASE("what is open at the top is no solid", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.3, -0.5, 0.6});
  const Eigen::Isometry3d X_CB = X_CW * test::translation(0, 0, 0.06);
  std::vector<test::Patch> patches = test::box(X_CB, {0.25, 0.2, 0.12});
  patches.pop_back();
  patches.push_back(test::rectangle(X_CW, 1.2, 1.0));
  CHECK(detect(cloud_of(patches)).boxes.empty());
}

TEST_CASE("of a box seen from straight above the height is bounded by what it stands on",
          "[boxes]") {
  const Eigen::Vector3d size(0.14, 0.1, 0.08);
  std::vector<test::Patch> patches = {test::rectangle(test::translation(0, 0, 0.8), 2.0, 2.0)};
  const Eigen::Isometry3d X_CB =
      test::translation(0.01, -0.02, 0.8 - 0.5 * size.z()) *
      Eigen::Isometry3d(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()));
  append(test::box(X_CB, size), &patches);
  const DetectionResult result = detect(cloud_of(patches));
  REQUIRE(result.boxes.size() == 1);
  const Box& box = result.boxes[0];
  CHECK(box.faces.size() == 1);
  const Eigen::Vector3d truth = size_along(box, X_CB, size);
  CHECK(std::count(box.seen.begin(), box.seen.end(), false) == 1);
  for (int i = 0; i < 3; ++i) {
    CHECK(box.inner_B.sizes()[i] < truth[i] + 0.004);
    CHECK(box.outer_B.sizes()[i] > truth[i] - 0.004);
    CHECK(std::abs(box.size[i] - truth[i]) < 0.006);
    if (!box.seen[i]) CHECK(box.std[i] > 0.01);
  }
}

TEST_CASE("a side whose end is hidden is said to be unseen, and is within its bounds", "[boxes]") {
  const Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.7, 0.5});
  const Eigen::Vector3d size(0.24, 0.12, 0.1);
  const Eigen::Isometry3d X_CB = X_CW * standing(size, 0.0, 0.0, 0.0);
  // A tall thing near the camera, before the box's right end.
  const Eigen::Isometry3d X_CThing = X_CW * test::translation(0.09, -0.35, 0.2);
  std::vector<test::Patch> patches = {test::rectangle(X_CW, 2.0, 1.2)};
  append(test::box(X_CB, size), &patches);
  append(test::box(X_CThing, {0.08, 0.02, 0.4}), &patches);
  const DetectionResult result = detect(cloud_of(patches));
  const auto is_long = [&](const Box& box) {
    return (box.X_CB.translation() - X_CB.translation()).norm() < 0.1;
  };
  const auto found = std::find_if(result.boxes.begin(), result.boxes.end(), is_long);
  REQUIRE(found != result.boxes.end());
  const Eigen::Vector3d truth = size_along(*found, X_CB, size);
  for (int i = 0; i < 3; ++i) {
    if (truth[i] == Approx(size.x())) CHECK_FALSE(found->seen[i]);
    CHECK(found->inner_B.sizes()[i] < truth[i] + 0.005);
    CHECK(found->outer_B.sizes()[i] > truth[i] - 0.005);
    if (found->seen[i]) CHECK(std::abs(found->size[i] - truth[i]) < 0.005);
  }
}

TEST_CASE("a moved cloud with its moved viewpoint gives the moved box", "[boxes][law]") {
  const Eigen::Isometry3d X(Eigen::Translation3d(0.4, -0.2, 0.3) *
                            Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -1).normalized()));
  std::vector<Detection> detections = test::table_result().detections;
  const std::vector<Box> here = find_boxes(test::table_cloud(), detections);
  for (Detection& d : detections) {
    d.X_CQ = X * d.X_CQ;
    d.Q_C = d.Q_C.transformed(X);
  }
  const std::vector<Box> there = find_boxes(test::moved_cloud(test::table_cloud(), X), detections);
  REQUIRE(here.size() == 1);
  REQUIRE(there.size() == 1);
  CHECK(there[0].faces == here[0].faces);
  CHECK((there[0].size - here[0].size).norm() < 1e-4);
  CHECK((there[0].X_CB.translation() - X * here[0].X_CB.translation()).norm() < 1e-4);
}

TEST_CASE("detections without sense make no boxes and no failure", "[boxes][hostile]") {
  CHECK(find_boxes({}, {}).empty());
  std::vector<Detection> detections = test::table_result().detections;
  CHECK(find_boxes({}, detections).empty());
  for (const double huge : {1e300, -1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<Detection> some = detections;
    for (Detection& d : some) d.extent_Q.max().x() = huge;
    find_boxes(test::table_cloud(), some);
  }
  std::vector<Detection> far = detections, last = detections;
  for (Detection& d : far) d.X_CQ.translation() *= 1e12;
  CHECK(find_boxes(test::table_cloud(), far).empty());
  for (Detection& d : last) d.id = std::numeric_limits<int>::max();
  CHECK(find_boxes(test::table_cloud(), last).empty());
}

}  // namespace
}  // namespace quadrille

#include "process/runtime/viewer.hpp"

#include <algorithm>
#include <cstring>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <lcmtypes/drake/lcmt_viewer_draw.hpp>
#include <lcmtypes/drake/lcmt_viewer_load_robot.hpp>
#include <limits>
#include <map>
#include <string>

#include "support/catch.hpp"

namespace quadrille {
namespace {

template <class Message>
Message decode_viewer(std::span<const std::byte> bytes) {
  Message m;
  REQUIRE(m.decode(bytes.data(), 0, static_cast<int>(bytes.size())) ==
          static_cast<int>(bytes.size()));
  return m;
}

/// A viewer, and how often it published what.
struct Published {
  std::map<std::string, int> counts;
  drake::lcmt_viewer_load_robot load;
  drake::lcmt_viewer_draw draw;
  Viewer viewer{{"LOAD", "DRAW"},
                [this](const std::string& channel, std::span<const std::byte> bytes) {
                  ++counts[channel];
                  if (channel == "LOAD") load = decode_viewer<decltype(load)>(bytes);
                  if (channel == "DRAW") draw = decode_viewer<decltype(draw)>(bytes);
                }};
};

DetectionResult ball_at(double x, double radius) {
  Detection d;
  d.id = 1;
  d.type = QuadricType::kSphere;
  Vector10d q = Vector10d::Zero();
  q.head<3>().setOnes();
  q[9] = -radius * radius;
  d.X_CQ.translation() = Eigen::Vector3d(x, 0, 1);
  d.Q_C = Quadric(q).transformed(d.X_CQ);
  d.extent_Q = {Eigen::Vector3d::Constant(-radius), Eigen::Vector3d::Constant(radius)};
  d.dimensions = {{"radius", radius, 0.0}};
  DetectionResult result;
  result.detections = {d};
  return result;
}

}  // namespace

TEST_CASE("a scene is loaded when it changes, and drawn each time", "[viewer]") {
  Published got;
  got.viewer.show(1'000'000, links_of(ball_at(0.0, 0.1)));
  REQUIRE(got.load.num_links == 1);
  CHECK(got.load.link[0].geom[0].type == 2);  // SPHERE
  CHECK(got.load.link[0].geom[0].float_data == std::vector<float>{0.1f});
  // It moves, and its size is noisy.
  got.viewer.show(1'100'000, links_of(ball_at(0.3, 0.101)));
  CHECK(got.counts == std::map<std::string, int>{{"LOAD", 1}, {"DRAW", 2}});
  REQUIRE(got.draw.num_links == 1);
  CHECK(got.draw.link_name[0] == got.load.link[0].name);
  CHECK(got.draw.position[0] == std::vector<float>{0.3f, 0.0f, 1.0f});
  CHECK(got.draw.timestamp == 1100);
  got.viewer.show(1'200'000, links_of(ball_at(0.3, 0.2)));
  CHECK(got.counts["LOAD"] == 2);
  got.viewer.show(1'300'000, links_of({}));
  CHECK(got.counts["LOAD"] == 3);
  CHECK(got.load.num_links == 0);
}

TEST_CASE("a viewer that starts late gets the same scene again", "[viewer]") {
  Published got;
  got.viewer.show(0, links_of(ball_at(0.0, 0.1)));
  const auto first = got.load;
  got.viewer.show(4'900'000, links_of(ball_at(0.1, 0.1004)));
  CHECK(got.counts["LOAD"] == 1);
  got.viewer.show(5'000'000, links_of(ball_at(0.1, 0.1004)));
  CHECK(got.counts["LOAD"] == 2);
  // To the last bit, by which Meldis knows it and takes no heed.
  CHECK(got.load.link[0].geom[0].float_data == first.link[0].geom[0].float_data);
}

TEST_CASE("a quadric of no primitive shape is shown as a mesh", "[viewer]") {
  DetectionResult result = ball_at(0.0, 0.1);
  result.detections[0].type = QuadricType::kHyperboloidOneSheet;
  Published got;
  got.viewer.show(0, links_of(result));
  REQUIRE(got.load.num_links == 1);
  const auto& shape = got.load.link[0].geom[0];
  CHECK(shape.type == 4);  // MESH
  const auto vertices = static_cast<std::size_t>(shape.float_data[0]);
  const auto triangles = static_cast<std::size_t>(shape.float_data[1]);
  REQUIRE(triangles > 100);
  REQUIRE(shape.float_data.size() == 2 + 3 * vertices + 3 * triangles);
  for (std::size_t i = 0; i < vertices; ++i) {
    CHECK(Eigen::Vector3f(&shape.float_data[2 + 3 * i]).norm() == Approx(0.1f).epsilon(1e-4));
  }
  const auto first = shape.float_data.begin() + 2 + static_cast<std::ptrdiff_t>(3 * vertices);
  CHECK(*std::max_element(first, shape.float_data.end()) == static_cast<float>(vertices - 1));
}

TEST_CASE("the viewer's cloud is finite, thin, and has the layout that Meldis takes", "[viewer]") {
  bus::CloudMessage cloud{7, 1, {}};
  cloud.cloud.width = 400;
  cloud.cloud.height = 300;
  cloud.cloud.points.assign(120'000, {0.1f, 0.2f, 0.3f});
  for (std::size_t i = 0; i < 120'000; i += 3) {
    cloud.cloud.points[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  const Eigen::Isometry3d X_RC(Eigen::Translation3d(1, 0, 0));
  const auto m = decode_viewer<drake::lcmt_point_cloud>(encode_viewer_cloud(cloud, X_RC));
  CHECK(m.flags == 2);  // strictly finite, not big-endian
  CHECK(m.num_fields == 3);
  CHECK(m.point_step == 12);
  CHECK(m.width * m.height * 12 == m.data_size);
  CHECK(m.data_size > 12 * 10'000);
  CHECK(m.data_size <= 12 * 30'000);
  float x = 0.0f;
  std::memcpy(&x, m.data.data(), sizeof x);
  CHECK(x == 1.1f);
}

}  // namespace quadrille

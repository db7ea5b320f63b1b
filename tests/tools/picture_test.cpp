#include "picture/picture.hpp"

#include <png.h>

#include <cmath>
#include <limits>

#include "picture/png.hpp"
#include "picture/text.hpp"
#include "picture/view.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;

namespace {

/// A half sphere of radius 0.1 m, 0.6 m before the camera, in front of a wall.
PointCloud ball_before_wall() {
  PointCloud cloud;
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const Eigen::Vector3d ray((column - 79.5) / 150, (row - 59.5) / 150, 1);
      const double a = ray.squaredNorm(), b = -0.6, c = 0.36 - 0.01;
      const double discriminant = b * b - a * c;
      const double z = discriminant >= 0 ? (-b - std::sqrt(discriminant)) / a : 1.0;
      cloud.points.push_back((z * ray).cast<float>());
    }
  }
  return cloud;
}

DetectionResult ball_found() {
  Detection d;
  d.id = 1;
  d.type = QuadricType::kSphere;
  Vector10d q = Vector10d::Zero();
  q.head<3>().setOnes();
  q[9] = -0.01;
  d.X_CQ.translation() = Eigen::Vector3d(0, 0, 0.6);
  d.Q_C = Quadric(q).transformed(d.X_CQ);
  d.rms = 0.001;
  d.extent_Q = {Eigen::Vector3d(-.1, -.1, -.1), Eigen::Vector3d(.1, .1, .1)};
  d.dimensions = {{"radius", 0.1, 0.0}};
  DetectionResult result;
  result.detections = {d};
  return result;
}

/// How far a colour is from grey.
float saturation(const Color& color) { return color.maxCoeff() - color.minCoeff(); }

}  // namespace

TEST_CASE("a picture is a valid PNG of the width asked for", "[picture]") {
  const test::TempFolder folder;
  const PointCloud cloud = ball_before_wall();
  const DetectionResult result = ball_found();
  for (const int width : {640, 1280}) {
    const Image image = draw_picture({"ball.ply", cloud, result}, width);
    write_png(folder.path("a.png"), image);
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&header, folder.path("a.png").c_str()) != 0);
    header.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(header));
    REQUIRE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr) != 0);
    CHECK(static_cast<int>(header.width) == width);
    CHECK(static_cast<int>(header.height) == image.height());
    CHECK(pixels == image.bytes());
  }
  CHECK_THROWS_AS(write_png(folder.path("none/a.png"), Image(4, 4, Color::Zero())),
                  std::runtime_error);
}

TEST_CASE("a found ball is coloured where it is, the wall stays grey", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  const std::string title = "ball.ply";
  const DetectionResult result = ball_found();
  const Image with = draw_picture({title, cloud, result}, 640);
  const Image without = draw_picture({title, cloud, {}}, 640);
  const View view = fit_view(cloud, 640);
  const auto at = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector2i(view.project(p).value().cast<int>());
  };
  const Eigen::Vector2i middle = at({0.01, 0.015, 0.5}), wall = at({-0.4, 0.3, 1.0});
  CHECK(saturation(with.at(middle.x(), middle.y())) > 0.2f);
  CHECK(saturation(without.at(middle.x(), middle.y())) < 0.02f);
  CHECK(saturation(with.at(wall.x(), wall.y())) < 0.02f);
}

TEST_CASE("the same content gives the same picture", "[picture][determinism]") {
  const PointCloud cloud = ball_before_wall();
  const DetectionResult result = ball_found();
  const std::string title = "ball.ply";
  CHECK(draw_picture({title, cloud, result}, 320).bytes() ==
        draw_picture({title, cloud, result}, 320).bytes());
}

TEST_CASE("the legend has a line for each curved quadric, in its colour", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  const DetectionResult result = ball_found();
  const Image with = draw_picture({"ball.ply", cloud, result}, 640);
  const Image without = draw_picture({"ball.ply", cloud, {}}, 640);
  REQUIRE(with.height() > without.height());
  float most = 0.0f;
  for (int row = without.height(); row < with.height(); ++row) {
    for (int column = 0; column < 300; ++column) {
      most = std::max(most, saturation(with.at(column, row)));
    }
  }
  CHECK(most > 0.2f);
}

TEST_CASE("a box is drawn by its edges, the hidden ones faintly, with a line in the legend",
          "[picture][boxes]") {
  const PointCloud cloud = ball_before_wall();
  DetectionResult result;
  Box box;
  box.id = 4;
  box.size = {0.2, 0.16, 0.1};
  // Turned, so that three sides are seen.
  box.X_CB = Eigen::Translation3d(0.0, 0.0, 0.7) *
             Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX()) *
             Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY());
  result.boxes = {box};
  const std::string title = "box.ply";
  const Image with = draw_picture({title, cloud, result}, 640);
  const Image without = draw_picture({title, cloud, {}}, 640);
  CHECK(with.height() > without.height());
  const View view = fit_view(cloud, 640);
  // The middles of the twelve edges: nine are strong, the three at the hidden corner faint.
  int strong = 0, faint = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double u : {-0.5, 0.5}) {
      for (const double v : {-0.5, 0.5}) {
        Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
        p_B[(axis + 1) % 3] = u * box.size[(axis + 1) % 3];
        p_B[(axis + 2) % 3] = v * box.size[(axis + 2) % 3];
        const Eigen::Vector2i at = view.project(box.X_CB * p_B).value().cast<int>();
        const float colour = saturation(with.at(at.x(), at.y()));
        strong += colour > 0.25f;
        faint += colour > 0.05f && colour <= 0.25f;
      }
    }
  }
  CHECK(strong == 9);
  CHECK(faint == 3);
}

TEST_CASE("grasps change a picture", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  const DetectionResult result = ball_found();
  Gripper gripper;
  gripper.finger = {0.02, 0.02, 0.05};
  gripper.palm = {0.06, 0.2, 0.06};
  GraspPlan plan;
  Grasp grasp;
  grasp.target = 1;
  grasp.preshape = 0.08;
  grasp.X_CG.translation() = Eigen::Vector3d(0, 0, 0.6);
  grasp.contacts_C = {Eigen::Vector3d(0, -0.04, 0.6), Eigen::Vector3d(0, 0.04, 0.6)};
  plan.grasps = {grasp};
  const std::string title = "ball.ply";
  const Image image = draw_picture({title, cloud, result, &plan, &gripper}, 640);
  const Eigen::Vector2i contact =
      fit_view(cloud, 640).project(grasp.contacts_C[0]).value().cast<int>();
  CHECK(image.at(contact.x(), contact.y()).isApprox(Color(1.0f, 0.25f, 0.2f), 0.01f));
}

TEST_CASE("a plan without grasps is told in red", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  GraspPlan none, one;
  one.grasps.resize(1);
  one.grasps[0].target = -1;
  const Gripper gripper;
  const auto reddest = [&](const GraspPlan& plan) {
    const Image image = draw_picture({"ball.ply", cloud, {}, &plan, &gripper}, 1280);
    float most = 0.0f;
    for (int row = image.height() - 25; row < image.height(); ++row) {
      for (int column = 0; column < image.width(); ++column) {
        const Color& c = image.at(column, row);
        most = std::max(most, c.x() - std::max(c.y(), c.z()));
      }
    }
    return most;
  };
  CHECK(reddest(none) > 0.5f);
  CHECK(reddest(one) < 0.05f);
}

TEST_CASE("pictures of strange clouds are drawn without harm", "[picture][hostile]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PointCloud cloud;
  const auto draw = [&] {
    const std::string title = "odd \x01\xff name";
    DetectionResult result = ball_found();
    result.detections.push_back({});
    result.detections.back().Q_C = Quadric(Vector10d(Vector10d::Constant(nan)));
    return draw_picture({title, cloud, result}, 200).width();
  };
  CHECK(draw() == 200);
  cloud.points = {{nan, nan, nan}};
  CHECK(draw() == 200);
  cloud.points = {{0, 0, 1}};
  CHECK(draw() == 200);
  cloud.points.assign(100, {0, 0, -1});
  CHECK(draw() == 200);
  cloud.points = {{1e30f, 1, 1}, {-1e30f, 1, 1e30f}, {1, 1, 1e-30f}, {0, 0, 0}};
  CHECK(draw() == 200);
  cloud.points.clear();
  for (int i = 0; i < 50; ++i) cloud.points.push_back({0.01f * i, 0, 0});
  CHECK(draw() == 200);
}

TEST_CASE("a cloud all around its viewpoint is seen from outside", "[picture]") {
  PointCloud cloud;
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      for (const float side : {-1.0f, 1.0f}) cloud.points.push_back({0.1f * i, 0.1f * j, side});
    }
  }
  const View view = fit_view(cloud, 400);
  for (const Eigen::Vector3f& p : cloud.points) {
    const auto at = view.project(p.cast<double>());
    REQUIRE(at.has_value());
    CHECK(at->x() > -20);
    CHECK(at->x() < 420);
  }
}

TEST_CASE("letters differ, and text beyond the image is cut", "[picture]") {
  Image a(20, 20, Color::Zero()), b(20, 20, Color::Zero());
  draw_text("b", 2, 2, 1, Color::Ones(), &a);
  draw_text("d", 2, 2, 1, Color::Ones(), &b);
  CHECK(a.bytes() != b.bytes());
  draw_text("a long text", -30, 15, 4, Color::Ones(), &a);
}

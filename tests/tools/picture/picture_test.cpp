#include "picture/picture.hpp"

#include <png.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "picture/view.hpp"
#include "support/catch.hpp"
#include "tools/picture/ball_before_wall.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// How far a colour is from grey.
float saturation(const Color& color) { return color.maxCoeff() - color.minCoeff(); }

/// The pixels of a PNG file, as libpng reads it.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Color at(int x, int y) const {
    const std::uint8_t* p = &rgb[3 * (static_cast<std::size_t>(y) * width + x)];
    return Color(p[0], p[1], p[2]) / 255.0f;
  }
};

Pixels read_png(const std::string& path) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&header, path.c_str()) != 0);
  header.format = PNG_FORMAT_RGB;
  Pixels pixels{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  pixels.rgb.resize(PNG_IMAGE_SIZE(header));
  REQUIRE(png_image_finish_read(&header, nullptr, pixels.rgb.data(), 0, nullptr) != 0);
  return pixels;
}

Pixels draw_picture(const PictureContent& content, int width) {
  const test::TempFolder folder;
  write_picture(folder.path("a.png"), content, {.width = width});
  return read_png(folder.path("a.png"));
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a picture is a valid PNG of the width asked for", "[picture]") {
  const test::TempFolder folder;
  const PointCloud cloud = ball_before_wall();
  const DetectionResult result = ball_found();
  for (const int width : {640, 1280}) {
    const Pixels pixels = draw_picture({"ball.ply", cloud, result}, width);
    CHECK(pixels.width == width);
    CHECK(pixels.height > fit_view(cloud, width).height);
  }
  CHECK_THROWS_AS(write_picture(folder.path("none/a.png"), {"ball.ply", cloud, result}),
                  std::runtime_error);
  CHECK_THROWS_AS(write_picture(folder.path("a.jpg"), {"ball.ply", cloud, result}),
                  std::invalid_argument);
}

TEST_CASE("SVG and PDF hold the cloud as an image, all else as lines, and are small", "[picture]") {
  const test::TempFolder folder;
  const PointCloud cloud = ball_before_wall();
  const DetectionResult result = ball_found();
  const std::string title = "ball.ply";
  for (const std::string name : {"a.svg", "a.pdf"}) {
    write_picture(folder.path(name), {title, cloud, result});
    const std::string first = read_text(folder.path(name));
    CHECK(first.size() < 500'000);
    write_picture(folder.path(name), {title, cloud, result});
    // Cairo numbers what an SVG defines over all files of a process.
    if (name == "a.pdf") CHECK((read_text(folder.path(name)) == first));
  }
  const std::string svg = read_text(folder.path("a.svg")), pdf = read_text(folder.path("a.pdf"));
  const auto count = [&](const std::string& word) {
    int found = 0;
    for (auto at = svg.find(word); at != std::string::npos; at = svg.find(word, at + 1)) ++found;
    return found;
  };
  CHECK(svg.starts_with("<?xml"));
  CHECK(count("<image") == 1);
  CHECK(count("<path") > 4);
  CHECK(pdf.starts_with("%PDF-"));
  CHECK(pdf.find("/Subtype /Image") != std::string::npos);
}

TEST_CASE("a found ball is coloured where it is, the wall stays grey", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  const std::string title = "ball.ply";
  const DetectionResult result = ball_found();
  const Pixels with = draw_picture({title, cloud, result}, 640);
  const Pixels without = draw_picture({title, cloud, {}}, 640);
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
  CHECK(draw_picture({title, cloud, result}, 320).rgb ==
        draw_picture({title, cloud, result}, 320).rgb);
}

TEST_CASE("the legend has a line for each curved quadric, in its colour", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  const DetectionResult result = ball_found();
  const Pixels with = draw_picture({"ball.ply", cloud, result}, 640);
  const Pixels without = draw_picture({"ball.ply", cloud, {}}, 640);
  REQUIRE(with.height > without.height);
  float most = 0.0f;
  for (int row = without.height; row < with.height; ++row) {
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
  const Pixels with = draw_picture({title, cloud, result}, 640);
  const Pixels without = draw_picture({title, cloud, {}}, 640);
  CHECK(with.height > without.height);
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
  const Gripper gripper = make_gripper();
  const GraspPlan plan = plan_on_ball();
  const std::string title = "ball.ply";
  const Pixels image = draw_picture({title, cloud, result, &plan, &gripper}, 640);
  const Eigen::Vector2i contact =
      fit_view(cloud, 640).project(plan.grasps[0].contacts_C[0]).value().cast<int>();
  CHECK(image.at(contact.x(), contact.y()).isApprox(Color(1.0f, 0.25f, 0.2f), 0.01f));
}

TEST_CASE("a plan without grasps is told in red", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  GraspPlan none, one;
  one.grasps.resize(1);
  one.grasps[0].target = -1;
  const Gripper gripper;
  const auto reddest = [&](const GraspPlan& plan) {
    const Pixels image = draw_picture({"ball.ply", cloud, {}, &plan, &gripper}, 1280);
    float most = 0.0f;
    for (int row = image.height - 25; row < image.height; ++row) {
      for (int column = 0; column < image.width; ++column) {
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
    return draw_picture({title, cloud, result}, 200).width;
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

#include "quadrille/detector/pinhole.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kMaxPixels = 4e6;
constexpr int kWidth = 320, kHeight = 240;

/// A wall across the view at depth z.
Patch wall(double z) { return rectangle(translation(0, 0, z), 1e3, 1e3); }

PointCloud shuffled(PointCloud cloud) {
  RandomStream random(81, 0);
  for (int i = static_cast<int>(cloud.points.size()) - 1; i > 0; --i) {
    std::swap(cloud.points[static_cast<std::size_t>(i)],
              cloud.points[static_cast<std::size_t>(random.below(i + 1))]);
  }
  cloud.width = cloud.height = 0;
  return cloud;
}

/// A wall at z = 1 in rows of the tangents that tangent(i, j) gives.
template <class Tangent>
PointCloud rows(Tangent&& tangent) {
  PointCloud cloud;
  for (int j = 0; j < kHeight; ++j) {
    for (int i = 0; i < kWidth; ++i) {
      const Eigen::Vector2d t = tangent(i - 0.5 * (kWidth - 1), j - 0.5 * (kHeight - 1));
      cloud.points.emplace_back(t.homogeneous().cast<float>());
    }
  }
  return cloud;
}

/// Rows of points whose steps along x are tiny, but for the last one, at x = 1.
PointCloud rows_of_tiny_steps(float step) {
  PointCloud cloud;
  for (int row = 0; row < 20; ++row) {
    const float y = 0.05f * static_cast<float>(row);
    for (int n = 0; n < 62; ++n) cloud.points.emplace_back(static_cast<float>(n) * step, y, 1.0f);
    cloud.points.emplace_back(1.0f, y, 1.0f);
  }
  return cloud;
}

double count_pixels(const PinholeImage& image) {
  return static_cast<double>(image.width) * image.height;
}

/// The pixel image that a cloud of any kind is given.
PinholeImage pixels_of(const PointCloud& cloud) {
  const auto view = look_from_viewpoint(cloud);
  REQUIRE(view);
  return find_pixels(cloud, *view, kMaxPixels);
}

/// Points in each pixel of the image; each has to lie in it.
std::vector<int> points_of_pixels(const PinholeImage& image, const PointCloud& cloud) {
  const auto view = look_from_viewpoint(cloud);
  std::vector<int> points(static_cast<std::size_t>(image.width * image.height), 0);
  for (const Eigen::Vector3f& p : cloud.points) {
    const Eigen::Array2f at = ((*view)(p).head<2>().array() - image.corner) / image.pitch;
    const int i = static_cast<int>(std::floor(at.x())), j = static_cast<int>(std::floor(at.y()));
    REQUIRE((i >= 0 && j >= 0 && i < image.width && j < image.height));
    ++points[static_cast<std::size_t>(j * image.width + i)];
  }
  return points;
}

}  // namespace

TEST_CASE("pitch and phase of the pixels are recovered from the points", "[pinhole]") {
  for (const double pitch : {1.0 / 300.0, 1.0 / 525.3}) {
    Camera camera;
    camera.pitch = pitch;
    const PointCloud cloud = render({wall(1.3)}, camera);
    const auto view = find_view(cloud);
    REQUIRE(view);
    CHECK(view->X_VC.isApprox(Eigen::Isometry3f::Identity()));
    CHECK(view->seen == 320 * 240);
    const auto image = find_image(cloud, *view);
    REQUIRE(image);
    // The corner of the first pixel stands half a pixel before its centre.
    const Eigen::Array2d corner(-160 * pitch, -120 * pitch);
    for (int axis = 0; axis < 2; ++axis) {
      CHECK(image->pitch[axis] == Approx(pitch).epsilon(1e-4));
      CHECK(image->corner[axis] == Approx(corner[axis]).margin(0.05 * pitch));
    }
    CHECK(image->width == 320);
    CHECK(image->height == 240);
  }
}

TEST_CASE("without an order of points the pitch follows from their density", "[pinhole]") {
  const PointCloud cloud = shuffled(render({wall(1.0)}));
  const auto view = find_view(cloud);
  REQUIRE(view);
  const auto image = find_image(cloud, *view);
  REQUIRE(image);
  CHECK(image->pitch.x() == Approx(1.0 / 300.0).epsilon(0.35));
  CHECK(image->pitch.y() == image->pitch.x());
}

TEST_CASE("a cloud in another frame is seen from its viewpoint along its mean direction",
          "[pinhole]") {
  PointCloud cloud = render({wall(1.0)});
  Eigen::Isometry3d X = translation(0.5, -2.0, 3.0);
  X.rotate(Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, -1).normalized()));
  for (Eigen::Vector3f& p : cloud.points) p = (X * p.cast<double>()).cast<float>();
  cloud.viewpoint = X.translation();
  const auto view = find_view(cloud);
  REQUIRE(view);
  CHECK((view->X_VC * cloud.viewpoint.cast<float>()).norm() < 1e-5f);
  const Eigen::Vector3d axis = X.linear().col(2);
  CHECK((view->X_VC.linear() * axis.cast<float>()).z() > 0.9999f);
  for (const Eigen::Vector3f& p : cloud.points)
    REQUIRE((*view)(p).z() == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("points all around the viewpoint or too few of them are no single view",
          "[pinhole][degenerate]") {
  PointCloud around;
  RandomStream random(82, 0);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d d(gaussian(random), gaussian(random), gaussian(random));
    around.points.push_back(d.normalized().cast<float>());
  }
  CHECK_FALSE(find_view(around));
  PointCloud few = render({wall(1.0)});
  few.points.resize(40);
  CHECK_FALSE(find_view(few));
  CHECK_FALSE(find_view(PointCloud()));
}

TEST_CASE("a view tells which points it sees, and how far they reach", "[pinhole]") {
  PointCloud cloud;
  cloud.points = {{0.0f, 0.0f, 1.0f},  {0.5f, -0.2f, 1.0f}, {-1.0f, 0.4f, 2.0f},
                  {5.0f, 0.0f, 1.0f},  {0.0f, -5.0f, 1.0f}, {0.0f, 0.0f, 1e-5f},
                  {NAN, 0.0f, 1.0f},   {0.1f, 0.1f, NAN},   {0.0f, 0.0f, INFINITY},
                  {0.0f, 0.01f, 1.0f}, {0.01f, 0.0f, 1.0f}};
  const auto view = look_from_viewpoint(cloud);
  REQUIRE(view);
  CHECK(view->X_VC.isApprox(Eigen::Isometry3f::Identity()));
  CHECK(view->seen == 5);
  CHECK(view->unseen == 3);
  CHECK(view->bounds.min().isApprox(Eigen::Vector2f(-0.5f, -0.2f)));
  CHECK(view->bounds.max().isApprox(Eigen::Vector2f(0.5f, 0.2f)));
  CHECK_FALSE(look_from_viewpoint(PointCloud()));
}

TEST_CASE("the pixels of a camera are found as they are", "[pinhole]") {
  // Square pixels, and ones that are wider or higher by a little or by much.
  for (const double fy : {262.5, 262.7, 265.0, 200.0, 400.0}) {
    constexpr double kFx = 262.5;
    const PointCloud cloud =
        rows([&](double i, double j) { return Eigen::Vector2d(i / kFx, j / fy); });
    const PinholeImage image = pixels_of(cloud);
    CAPTURE(fy);
    REQUIRE(image.width == kWidth);
    REQUIRE(image.height == kHeight);
    CHECK(image.pitch.x() == Approx(1.0 / kFx).epsilon(1e-5));
    CHECK(image.pitch.y() == Approx(1.0 / fy).epsilon(1e-5));
    // Each has one point, and the rays through the centres are those of the points.
    CHECK(points_of_pixels(image, cloud) == std::vector<int>(kWidth * kHeight, 1));
    const Eigen::Array2f first = image.corner + 0.5f * image.pitch;
    CHECK(first.x() == Approx(-0.5 * (kWidth - 1) / kFx).margin(1e-6));
    CHECK(first.y() == Approx(-0.5 * (kHeight - 1) / fy).margin(1e-6));
  }
}

TEST_CASE("the pixels of a camera are found in a cloud with gaps", "[pinhole]") {
  PointCloud cloud = rows([](double i, double j) { return Eigen::Vector2d(i / 300.0, j / 300.0); });
  RandomStream random(83, 0);
  std::vector<Eigen::Vector3f> kept;
  for (std::size_t n = 0; n < cloud.points.size(); ++n) {
    const bool corner = n == 0 || n + 1 == cloud.points.size();
    if (corner || (random.uniform() < 0.7 && n / kWidth % 40 > 9)) kept.push_back(cloud.points[n]);
  }
  cloud.points = kept;
  const PinholeImage image = pixels_of(cloud);
  CHECK(image.width == kWidth);
  CHECK(image.height == kHeight);
}

TEST_CASE("in rows that are no camera's the pixels are as coarse as without order", "[pinhole]") {
  // Of a lens that stretches the image outward by up to a fifth.
  const PointCloud cloud = rows([](double i, double j) {
    const Eigen::Vector2d t = Eigen::Vector2d(i, j) / 300.0;
    return Eigen::Vector2d(t * (1.0 + 0.4 * t.squaredNorm()));
  });
  const PinholeImage image = pixels_of(cloud), disordered = pixels_of(shuffled(cloud));
  CHECK(image.pitch.x() == disordered.pitch.x());
  CHECK(image.pitch.x() > 1.2f / 300.0f);
}

TEST_CASE("without an order of points the usual pixel holds two, however few points there are",
          "[pinhole]") {
  for (const int points : {100, 1000, 10000, 100000}) {
    PointCloud cloud;
    RandomStream random(84, 0);
    for (int n = 0; n < points; ++n) {
      cloud.points.emplace_back(static_cast<float>(random.uniform() - 0.5),
                                static_cast<float>(random.uniform() - 0.5), 1.0f);
    }
    const PinholeImage image = pixels_of(cloud);
    CAPTURE(points, image.width, image.height);
    CHECK(points / count_pixels(image) > 0.8);
    CHECK(points / count_pixels(image) < 4.0);
  }
}

TEST_CASE("points in tiny steps do not make an image of more pixels than asked for",
          "[pinhole][hostile]") {
  for (const int exponent : {-10, -24, -40, -60, -100, -126, -140, -149}) {
    for (const bool turned : {false, true}) {
      PointCloud cloud = rows_of_tiny_steps(std::ldexp(1.0f, exponent));
      if (turned) {
        for (Eigen::Vector3f& p : cloud.points) std::swap(p.x(), p.y());
      }
      const PinholeImage image = pixels_of(cloud);
      CAPTURE(exponent, turned, image.width, image.height);
      CHECK(count_pixels(image) >= 1.0);
      CHECK(count_pixels(image) <= kMaxPixels);
    }
  }
}

TEST_CASE("a single row of many points stays within as many pixels", "[pinhole][hostile]") {
  PointCloud cloud;
  for (int n = 0; n < 20000; ++n) {
    cloud.points.emplace_back(std::ldexp(static_cast<float>(n), -30), 0.0f, 1.0f);
  }
  cloud.points.emplace_back(1.9f, 0.0f, 1.0f);
  const PinholeImage image = pixels_of(cloud);
  CHECK(count_pixels(image) >= 1.0);
  CHECK(count_pixels(image) <= kMaxPixels);
}

TEST_CASE("an image of more pixels than asked for becomes coarser and holds all points",
          "[pinhole]") {
  const PointCloud cloud =
      rows([](double i, double j) { return Eigen::Vector2d(i / 300.0, j / 300.0); });
  const auto view = look_from_viewpoint(cloud);
  for (const double max_pixels : {4.0, 100.0, 12345.0}) {
    const PinholeImage image = find_pixels(cloud, *view, max_pixels);
    CHECK(count_pixels(image) <= max_pixels);
    CHECK(count_pixels(image) > 0.5 * max_pixels - 4.0);
    points_of_pixels(image, cloud);
  }
}

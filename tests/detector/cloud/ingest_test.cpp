#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"
#include "support/catch.hpp"

using quadrille::PointCloud;
using quadrille::PointLayout;
using quadrille::read_points;

namespace {

constexpr std::byte kFiller{0xa5};

/// Writes a number at an offset, in the byte order of the layout.
template <class Scalar>
void put(std::vector<std::byte>* bytes, std::size_t at, Scalar value, bool big_endian) {
  auto raw = std::bit_cast<std::array<std::byte, sizeof(Scalar)>>(value);
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
  std::copy(raw.begin(), raw.end(), bytes->begin() + static_cast<std::ptrdiff_t>(at));
}

/// Bytes of points in a layout; what lies between the coordinates is filled with noise.
std::vector<std::byte> write(const std::vector<std::array<double, 3>>& points,
                             const PointLayout& layout) {
  const std::size_t row_step = layout.row_step ? layout.row_step : layout.width * layout.point_step;
  std::vector<std::byte> bytes(row_step * layout.height, kFiller);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t record = i / layout.width * row_step + i % layout.width * layout.point_step;
    const std::array<std::size_t, 3> offsets = {layout.x, layout.y, layout.z};
    for (std::size_t k = 0; k < 3; ++k) {
      if (layout.scalar == PointLayout::Scalar::kFloat64) {
        put(&bytes, record + offsets[k], points[i][k], layout.big_endian);
      } else {
        put(&bytes, record + offsets[k], static_cast<float>(points[i][k]), layout.big_endian);
      }
    }
  }
  return bytes;
}

PointLayout row_of(std::size_t width) {
  PointLayout layout;
  layout.width = width;
  return layout;
}

const std::vector<std::array<double, 3>> kPoints = {{1, 2, 3},  {-4, 0.5, 6}, {0, 0, 0.25},
                                                    {7, -8, 9}, {1, 1, 1},    {2, 2, 2}};

}  // namespace

TEST_CASE("both widths, both byte orders and any offsets give the same points", "[ingest]") {
  for (const auto scalar : {PointLayout::Scalar::kFloat32, PointLayout::Scalar::kFloat64}) {
    for (const bool big_endian : {false, true}) {
      PointLayout layout;
      layout.scalar = scalar;
      layout.big_endian = big_endian;
      layout.z = 3, layout.x = 13, layout.y = 22;
      layout.point_step = 33;
      layout.width = kPoints.size();
      const PointCloud cloud = read_points(write(kPoints, layout), layout);
      REQUIRE(cloud.points.size() == kPoints.size());
      CHECK_FALSE(cloud.organised());
      CHECK(cloud.read == kPoints.size());
      CHECK(cloud.viewpoint.isZero());
      for (std::size_t i = 0; i < kPoints.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          CHECK(cloud.points[i][static_cast<Eigen::Index>(k)] == static_cast<float>(kPoints[i][k]));
        }
      }
    }
  }
}

TEST_CASE("rows may be padded and the last one need not be", "[ingest]") {
  PointLayout layout;
  layout.width = 3, layout.height = 2;
  layout.row_step = 3 * 12 + 20;
  std::vector<std::byte> bytes = write(kPoints, layout);
  bytes.resize(layout.row_step + 3 * 12);
  const PointCloud cloud = read_points(bytes, layout);
  CHECK(cloud.organised());
  CHECK(cloud.width == 3);
  CHECK(cloud.height == 2);
  CHECK(cloud.points[3] == Eigen::Vector3f(7, -8, 9));
  bytes.pop_back();
  CHECK_THROWS_AS(read_points(bytes, layout), std::invalid_argument);
}

TEST_CASE("missing points are dropped from a list and kept as NaN in an image", "[ingest]") {
  std::vector<std::array<double, 3>> points = kPoints;
  points[0] = {NAN, 1, 1};
  points[2] = {0, 0, 0};
  points[3] = {1, std::numeric_limits<double>::infinity(), 1};
  const PointLayout list = row_of(6);
  const PointCloud dropped = read_points(write(points, list), list);
  CHECK(dropped.read == 6);
  REQUIRE(dropped.points.size() == 3);
  CHECK(dropped.points[0] == Eigen::Vector3f(-4, 0.5, 6));
  CHECK(dropped.points[1] == Eigen::Vector3f(1, 1, 1));

  PointLayout image;
  image.width = 2, image.height = 3;
  const PointCloud kept = read_points(write(points, image), image);
  REQUIRE(kept.points.size() == 6);
  for (const std::size_t i : {0, 2, 3}) CHECK(kept.points[i].array().isNaN().all());
  for (const std::size_t i : {1, 4, 5}) CHECK(kept.points[i].allFinite());
}

TEST_CASE("an image has the same points in whatever way its records are stored", "[ingest]") {
  constexpr std::size_t kWidth = 37, kHeight = 5;
  std::vector<std::array<double, 3>> points;
  for (std::size_t i = 0; i < kWidth * kHeight; ++i) {
    const double x = static_cast<double>(i);
    points.push_back({0.25 * x - 4.0, 3.0 - 0.5 * x, 1.0 + 0.125 * x});
  }
  // Whole runs of points have all coordinates; others have none, codes, or zeros among them.
  points[40] = {0, 0, 0};
  points[45] = {1, 0, 2};
  points[77] = {NAN, NAN, NAN};
  points[78] = {1, 2, -std::numeric_limits<double>::infinity()};
  points[kWidth * kHeight - 1] = {0, -0.0, 0};
  PointLayout swapped;
  swapped.width = kWidth, swapped.height = kHeight;
  swapped.big_endian = true;
  const PointCloud expected = read_points(write(points, swapped), swapped);
  REQUIRE(expected.points.size() == points.size());
  CHECK(expected.points[45] == Eigen::Vector3f(1, 0, 2));
  for (const std::size_t step : {12u, 16u}) {
    PointLayout layout = swapped;
    layout.big_endian = false;
    layout.point_step = step;
    layout.row_step = kWidth * step + 8;
    if (step == 16) layout.x = 4, layout.y = 0, layout.z = 12;
    const PointCloud cloud = read_points(write(points, layout), layout);
    CHECK(cloud.read == expected.read);
    REQUIRE(cloud.points.size() == expected.points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool missing = expected.points[i].array().isNaN().all();
      CHECK(missing == (i == 40 || i == 77 || i == 78 || i + 1 == points.size()));
      CHECK((missing ? cloud.points[i].array().isNaN().all()
                     : cloud.points[i] == expected.points[i]));
    }
  }
}

TEST_CASE("a float64 beyond the range of float32 counts as missing", "[ingest][hostile]") {
  PointLayout layout = row_of(2);
  layout.scalar = PointLayout::Scalar::kFloat64;
  layout.y = 8, layout.z = 16, layout.point_step = 24;
  const PointCloud cloud = read_points(write({{1e300, 0, 1}, {1, 2, 3}}, layout), layout);
  REQUIRE(cloud.points.size() == 1);
  CHECK(cloud.points[0] == Eigen::Vector3f(1, 2, 3));
}

TEST_CASE("an empty cloud is read as an empty cloud", "[ingest][degenerate]") {
  CHECK(read_points({}, row_of(0)).points.empty());
}

TEST_CASE("layouts that do not fit into the bytes are refused", "[ingest][hostile]") {
  constexpr std::size_t kHuge = std::numeric_limits<std::size_t>::max();
  const std::vector<std::byte> bytes(1200, std::byte{0});
  const auto refused = [&](auto&& change) {
    PointLayout layout = row_of(100);
    REQUIRE_NOTHROW(read_points(bytes, layout));
    change(&layout);
    CHECK_THROWS_AS(read_points(bytes, layout), std::invalid_argument);
  };
  refused([](PointLayout* l) { l->width = 101; });
  refused([](PointLayout* l) { l->height = 2; });
  refused([](PointLayout* l) { l->scalar = PointLayout::Scalar::kFloat64; });
  refused([](PointLayout* l) { l->z = 9; });
  refused([](PointLayout* l) { l->point_step = 0; });
  refused([](PointLayout* l) { l->width = 50, l->height = 2, l->row_step = 599; });
  // Products and sums that wrap around to something small.
  refused([](PointLayout* l) { l->width = kHuge / 12 + 2; });
  refused([](PointLayout* l) { l->width = kHuge / 12 + 2, l->height = 2; });
  refused([](PointLayout* l) { l->width = 1, l->height = kHuge / 16 + 2, l->row_step = 16; });
  refused([](PointLayout* l) { l->width = 1, l->height = 3, l->row_step = kHuge / 2 + 1; });
  refused([](PointLayout* l) { l->width = 3, l->height = 2, l->row_step = kHuge - 11; });
  refused([](PointLayout* l) { l->x = kHuge - 3; });
  refused([](PointLayout* l) { l->rgb = {{0, 1, kHuge}}; });
  refused([](PointLayout* l) { l->rgb = {{12, 1, 2}}; });
}

TEST_CASE("points are moved before they are rounded to single precision", "[ingest]") {
  // Far out single precision steps by half a metre.
  const std::array<double, 6> far = {5e6 + 0.25, 0.5, 0.125, 0.0, 0.0, 0.0};
  PointLayout layout;
  layout.scalar = PointLayout::Scalar::kFloat64;
  layout.y = 8, layout.z = 16, layout.point_step = 24, layout.width = 2;
  const Eigen::Isometry3d X_CF(Eigen::Translation3d(-5e6, 0, 1));
  const PointCloud cloud = read_points(std::as_bytes(std::span(far)), layout, X_CF);
  // What is all zero is missing, wherever it would be moved to.
  REQUIRE(cloud.points.size() == 1);
  CHECK(cloud.points[0] == Eigen::Vector3f(0.25f, 0.5f, 1.125f));
}

#include "boxes/mixed_edge.hpp"

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

constexpr double kPitch = 0.001, kTolerance = 0.002, kGap = 0.06;
constexpr int kRows = 20;

/// The rows of a face in the plane z = 0 that end at x = 0, and beyond each of them points at
/// heights that a function tells from their distance [pitches].
template <class Height>
Rows rows_with(const Height& height) {
  Face face;
  face.n_C = Eigen::Vector3d::UnitZ();
  for (int row = 0; row < kRows; ++row) {
    for (int k = 0; k < 10; ++k) face.points_C.emplace_back(-kPitch * k, kPitch * (row + 0.5), 0.0);
  }
  Rows rows(face, Eigen::Vector3d::UnitX(), kPitch);
  for (Row& row : rows.all()) {
    row.seen = true;
    for (int k = 1; k <= 15; ++k) row.beside.push_back({kPitch * k, height(k), true});
  }
  return rows;
}

TEST_CASE("an outline without mixed pixels lies at the ends of the rows", "[boxes][mixed]") {
  const MixedPixels found = mixed_pixels(rows_with([](int) { return -kGap; }), kTolerance, kPitch);
  CHECK(found.rows >= kRows - 2);
  CHECK(found.mixed == 0);
  CHECK(found.reach == 0.0);
}

TEST_CASE("an outline lies in the middle of the pixels that float between face and background",
          "[boxes][mixed]") {
  RandomStream random(7, 0);
  // The two pixels on either side of the outline are nearer to their own surface.
  const auto height = [&](int k) {
    if (k > 4) return -kGap;
    return -kGap * ((k > 2 ? 0.5 : 0.0) + 0.5 * (0.05 + 0.9 * random.uniform()));
  };
  const MixedPixels found = mixed_pixels(rows_with(height), kTolerance, kPitch);
  CHECK(found.rows >= kRows - 2);
  CHECK(found.mixed > 0.9 * found.rows);
  CHECK(found.reach == Approx(2.0 * kPitch));
  CHECK(found.std < 0.5 * kPitch);
}

TEST_CASE("an outline lies in the middle of the pixels that a sensor lost there",
          "[boxes][mixed]") {
  // The outline is four and a half pitches beyond the ends: two pixels float on its near side, two
  // on the far side, and the two next to it are lost.
  Rows rows = rows_with([](int k) { return -kGap * (k < 5 ? 0.3 : k < 8 ? 0.8 : 1.0); });
  for (Row& row : rows.all()) {
    std::erase_if(row.beside, [](const Beside& point) {
      return point.distance > 3.5 * kPitch && point.distance < 5.5 * kPitch;
    });
  }
  const MixedPixels found = mixed_pixels(rows, kTolerance, kPitch);
  // Half a pitch beyond the ends of the rows is counted where there are no mixed pixels too.
  CHECK(found.reach + 0.5 * kPitch == Approx(4.5 * kPitch));
  // Behind the shadow of a second eye nothing tells how far the outline lies.
  for (Row& row : rows.all()) {
    std::erase_if(row.beside, [](const Beside& point) {
      return point.distance > 3.5 * kPitch && point.distance < 9.5 * kPitch;
    });
  }
  CHECK(mixed_pixels(rows, kTolerance, kPitch).reach == Approx(3.0 * kPitch));
}

TEST_CASE("rows do not tell if the background is near, slanted or not seen", "[boxes][mixed]") {
  const auto rows_that_tell = [](const auto& height) {
    return mixed_pixels(rows_with(height), kTolerance, kPitch).rows;
  };
  CHECK(rows_that_tell([](int) { return -0.008; }) == 0);
  CHECK(rows_that_tell([](int k) { return -0.005 * k; }) == 0);
  Rows rows = rows_with([](int) { return -kGap; });
  for (Row& row : rows.all()) row.beside.resize(5);
  CHECK(mixed_pixels(rows, kTolerance, kPitch).rows == 0);
}

TEST_CASE("nothing before a face and no row that did not see its end is mixed", "[boxes][mixed]") {
  CHECK(mixed_pixels(rows_with([](int) { return kGap; }), kTolerance, kPitch).rows == 0);
  Rows rows = rows_with([](int) { return -kGap; });
  for (Row& row : rows.all()) row.seen = false;
  const MixedPixels found = mixed_pixels(rows, kTolerance, kPitch);
  CHECK(found.rows == 0);
  CHECK(found.reach == 0.0);
  CHECK(found.std == 0.0);
}

}  // namespace
}  // namespace quadrille

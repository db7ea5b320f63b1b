#include "views/seen_through.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"
#include "views/contradiction.hpp"
#include "views/view_parts.hpp"

using namespace quadrille;
using Eigen::Vector3f;

namespace {

constexpr int kWidth = 60, kHeight = 44;

/// The depths of a camera that looks at a wall at z = 1 m and at a square of 0.2 m before it, whose
/// middle is at (x, 0).
/// @param eye     where the camera is
/// @param square  depth of the square's plane z [m]; 1 if there is none
/// @param R_VC    how the camera is turned
Sight sight_of(const Vector3f& eye, float x, float square,
               const Eigen::Matrix3f& R_VC = Eigen::Matrix3f::Identity()) {
  Sight sight;
  sight.X_VC.linear() = R_VC;
  sight.X_VC.translation() = -R_VC * eye;
  sight.step = 0.012f;
  sight.width = kWidth;
  sight.height = kHeight;
  sight.corner << -0.5f * sight.step * kWidth, -0.5f * sight.step * kHeight;
  for (int j = 0; j < kHeight; ++j) {
    for (int i = 0; i < kWidth; ++i) {
      const Eigen::Array2f cell(static_cast<float>(i), static_cast<float>(j));
      const Eigen::Array2f tangent = sight.corner + sight.step * (cell + 0.5f);
      // The depth of a place on the ray is how many times this vector leads to it.
      const Vector3f ray = R_VC.transpose() * Vector3f(tangent.x(), tangent.y(), 1.0f);
      const float before = (square - eye.z()) / ray.z();
      const Vector3f at = eye + before * ray;
      const bool meets = std::abs(at.x() - x) < 0.1f && std::abs(at.y()) < 0.1f;
      sight.w.push_back(meets ? 1.0f / before : ray.z() / (1.0f - eye.z()));
    }
  }
  return sight;
}

std::size_t count(const Mask& marked) {
  std::size_t n = 0;
  for (const char one : marked) n += one != 0;
  return n;
}

}  // namespace

TEST_CASE("cells are seen through as their places are", "[views]") {
  RandomStream random(8, 0);
  Sight view = sight_of(Vector3f::Zero(), 0.0f, 0.9f);
  const Vector3f axis = Vector3f(1.0f, -2.0f, 2.0f).normalized();
  Sight other =
      sight_of({0.2f, 0.05f, 0.1f}, 0.1f, 0.95f, Eigen::AngleAxisf(0.3f, axis).toRotationMatrix());
  for (Sight* sight : {&view, &other}) {
    for (float& w : sight->w) {
      const double chance = random.uniform();
      if (chance < 0.05) w = 0.0f;
      if (chance > 0.95) w *= static_cast<float>(0.7 + 0.6 * random.uniform());
    }
  }
  const Mask through = cells_seen_through(view, other);
  // The definition, by brute force: first all cells that are seen through by a wide margin, then,
  // until there are no more, neighbours of these that are seen through by a narrow one.
  Mask expected(view.w.size(), 0);
  for (bool grows = true, first = true; grows; first = false) {
    grows = false;
    for (int n = 0; n < kWidth * kHeight; ++n) {
      const int i = n % kWidth, j = n / kWidth;
      if (expected[n] || view.w[n] == 0.0f) continue;
      bool beside = false;
      for (const auto& [x, y] : {std::pair(i - 1, j), {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
        beside |= x >= 0 && y >= 0 && x < kWidth && y < kHeight && expected[y * kWidth + x];
      }
      if (!first && !beside) continue;
      expected[n] = sees_through(other, place_of_cell(view, i, j), first ? kWellBehind : kAtFoot);
      grows |= expected[n] != 0;
    }
    grows |= first;
  }
  CHECK(through == expected);
  CHECK(count(through) > 20);
  CHECK(count(through) < 1000);
  CHECK(count(cells_seen_through(view, Sight())) == 0);
  CHECK(cells_seen_through(Sight(), other).empty());
}

TEST_CASE("points at the border of a thing are seen through with its cells", "[views]") {
  const Sight before = sight_of(Vector3f::Zero(), 0.0f, 0.9f);
  const Sight after = sight_of({0.1f, 0.0f, 0.0f}, 0.0f, 1.0f);
  const Mask through = cells_seen_through(before, after);
  REQUIRE(count(through) > 100);
  // A point of the square in the first cell to its right that shows the wall.
  int i = kWidth / 2;
  while (before.w[kHeight / 2 * kWidth + i] > 1.0f) ++i;
  const auto point_at = [&](int column, float z) {
    const float tangent = before.corner.x() + before.step * (static_cast<float>(column) + 0.5f);
    return Vector3f(z * tangent, 0.0f, z);
  };
  const std::vector<Vector3f> points = {
      point_at(i, 0.9f),      // of the square, at its border
      point_at(i, 1.0f),      // of the wall behind it
      point_at(i + 5, 0.9f),  // before the wall, far from the square
      point_at(i - 2, 0.9f),  // of the square, shown by its cell
  };
  CHECK(border_points_seen_through(points, before, through, after) == Mask{1, 0, 0, 0});
  CHECK(points_seen_through(points, before, through, after) == Mask{0, 0, 0, 1});
  // If the square is still there, nothing is seen through.
  const Mask none = cells_seen_through(before, before);
  CHECK(count(none) == 0);
  CHECK(count(border_points_seen_through(points, before, none, before)) == 0);
}

TEST_CASE("a surface that shares samples with one that is gone loses these alone", "[views]") {
  // 20 samples of the square, which is taken away, and 24 of the wall, which stays.
  KeptParts kept;
  kept.sight = sight_of(Vector3f::Zero(), 0.0f, 0.9f);
  std::vector<int> gone, stays;
  for (int n = 0; n < 44; ++n) {
    const float x = 0.01f * static_cast<float>(n % 10 - 5);
    const float y = 0.02f * static_cast<float>(n / 10 - 2);
    const bool on_square = n < 20;
    kept.parts.finest.raw.emplace_back(on_square ? x : x + 0.25f, y, on_square ? 0.9f : 1.0f);
    // Two samples of the square and all of the wall are also those of the surface that stays, and
    // half of the wall also those of the surface that is gone.
    if (n < 32) gone.push_back(n);
    if (n >= 18) stays.push_back(n);
  }
  SurfaceSamples& finest = kept.parts.finest;
  finest.p = finest.n = finest.raw;
  finest.sigma.assign(44, 0.001f);
  finest.cell.assign(44, 0.01f);
  finest.count.assign(44, 1);
  finest.source.assign(44, 0);
  finest.first.assign(45, 0);
  kept.parts.coarse.first = {0};
  kept.scatter.assign(44, Eigen::Matrix3f::Zero());
  kept.parts.plane_of_cell.assign(44, -1);
  for (const std::vector<int>& region : {gone, stays}) {
    kept.parts.candidates.emplace_back().region = region;
  }
  const Sight newer = sight_of({0.1f, 0.0f, 0.0f}, 0.0f, 1.0f);
  const Sight older = kept.sight;
  const Contradiction contradiction(older, newer);
  const Mask through = contradiction.seen_through(finest.raw);
  REQUIRE(count(through) == 20);
  kept.drop(contradiction);
  REQUIRE(kept.parts.candidates.size() == 1);
  CHECK(kept.parts.candidates.front().region.size() == 12);
  CHECK(kept.parts.finest.size() == 12);
}

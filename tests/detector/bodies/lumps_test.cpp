#include "bodies/lumps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "bodies/support.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

/// A square table of 0.6 m at z = 0, seen from above.
std::vector<Support> square_table() {
  Support support;
  support.id = 4;
  support.n_C = Eigen::Vector3d::UnitZ();
  support.bounds_Q = {Eigen::Vector2d(-0.3, -0.3), Eigen::Vector2d(0.3, 0.3)};
  support.outlines_Q = {{{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}}};
  return {support};
}

/// The upper half of a ball whose middle is at (x, y), in cells of 3 mm, and `foot` above the
/// table.
SurfaceSamples dome(double x, double y, double radius, double foot) {
  SurfaceSamples samples;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 10; ++j) {
      const double along = 2.0 * M_PI * i / 40, up = 0.5 * M_PI * j / 10;
      samples.raw.emplace_back(Eigen::Vector3d(x + radius * std::cos(along) * std::cos(up),
                                               y + radius * std::sin(along) * std::cos(up),
                                               foot + radius * std::sin(up))
                                   .cast<float>());
      samples.sigma.push_back(0.0005f);
      samples.cell.push_back(0.003f);
    }
  }
  return samples;
}

std::optional<SceneBody> lump(const SurfaceSamples& samples, bool alone = true) {
  std::vector<int> piece(samples.raw.size());
  std::iota(piece.begin(), piece.end(), 0);
  const std::vector<Support> supports = square_table();
  const Support* support = lump_support(samples, piece, supports, alone);
  return support == nullptr ? std::nullopt : lump_of(samples, piece, *support);
}

TEST_CASE("a lump is as large as its points, and reaches down to its support", "[bodies][lumps]") {
  const auto body = lump(dome(0.1, -0.05, 0.04, 0.01));
  REQUIRE(body);
  CHECK(body->kind == BodyKind::kLump);
  CHECK(body->standing_on == 4);
  CHECK(body->size.x() == Approx(0.08).margin(0.001));
  CHECK(body->size.y() == Approx(0.08).margin(0.001));
  CHECK(body->size.z() == Approx(0.05).margin(0.001));
  CHECK((body->X_CB.translation() - Eigen::Vector3d(0.1, -0.05, 0.025)).norm() < 0.001);
  CHECK(body->seen == std::array<bool, 3>{false, false, true});
}

TEST_CASE("what does not rise above rounding and noise is no lump", "[bodies][lumps]") {
  CHECK(lump(dome(0.0, 0.0, 0.012, 0.0)));
  CHECK_FALSE(lump(dome(0.0, 0.0, 0.004, 0.0)));
  SurfaceSamples noisy = dome(0.0, 0.0, 0.012, 0.0);
  for (float& sigma : noisy.sigma) sigma = 0.002f;
  CHECK_FALSE(lump(noisy));
}

TEST_CASE("what lies on the support around a thing is no part of its lump", "[bodies][lumps]") {
  SurfaceSamples samples = dome(0.0, 0.0, 0.02, 0.01);
  const std::size_t count = samples.raw.size();
  for (const Eigen::Vector3f& p : dome(0.0, 0.0, 0.05, 0.0).raw) {
    samples.raw.emplace_back(p.x(), p.y(), 0.1f * p.z());
  }
  std::vector<int> piece(samples.raw.size());
  std::iota(piece.begin(), piece.end(), 0);
  piece.pop_back();
  const Mask above = above_support(samples, piece, square_table().front());
  REQUIRE(above.size() == samples.raw.size());
  CHECK(std::count(above.begin(), above.end(), 1) == static_cast<std::ptrdiff_t>(count));
  CHECK(std::all_of(above.begin(), above.begin() + static_cast<std::ptrdiff_t>(count),
                    [](char marked) { return marked != 0; }));
}

TEST_CASE("there are no lumps at the edge of a support or beside it", "[bodies][lumps]") {
  for (const double x : {0.28, 0.3, 0.34}) {
    CAPTURE(x);
    CHECK_FALSE(lump(dome(x, 0.0, 0.03, 0.0)));
    CHECK_FALSE(lump(dome(0.0, -x, 0.03, 0.0)));
  }
  CHECK(lump(dome(0.26, 0.26, 0.03, 0.0)));
}

TEST_CASE("what only one view shows at the edge of its support is no lump", "[bodies][lumps]") {
  std::vector<Support> supports = square_table();
  // The second view sees the half x > 0 alone.
  supports.front().outlines_Q.push_back({{0.0, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {0.0, 0.3}});
  SurfaceSamples samples = dome(0.01, 0.0, 0.03, 0.0);
  std::vector<int> piece(samples.raw.size());
  std::iota(piece.begin(), piece.end(), 0);
  samples.view.assign(piece.size(), 0);
  CHECK(lump_of(samples, piece, supports.front()));
  samples.view.assign(piece.size(), 1);
  CHECK_FALSE(lump_of(samples, piece, supports.front()));
  // A few samples of another view do not show it.
  std::fill_n(samples.view.begin(), piece.size() / 5, 0);
  CHECK_FALSE(lump_of(samples, piece, supports.front()));
  std::fill_n(samples.view.begin(), piece.size() / 2, 0);
  CHECK(lump_of(samples, piece, supports.front()));
}

TEST_CASE("a lump that many views share is one", "[bodies][lumps]") {
  constexpr std::size_t kViews = 8;
  std::vector<Support> supports = square_table();
  supports.front().outlines_Q.resize(kViews, supports.front().outlines_Q.front());
  SurfaceSamples samples = dome(0.0, 0.0, 0.03, 0.0);
  std::vector<int> piece(samples.raw.size());
  std::iota(piece.begin(), piece.end(), 0);
  for (std::size_t k = 0; k < piece.size(); ++k) {
    samples.view.push_back(static_cast<int>(k % kViews));
  }
  CHECK(lump_of(samples, piece, supports.front()));
}

TEST_CASE("a lump floats only if a surface that touches it may hide its foot", "[bodies][lumps]") {
  CHECK(lump(dome(0.0, 0.0, 0.03, 0.015)));
  CHECK_FALSE(lump(dome(0.0, 0.0, 0.03, 0.1)));
  const auto hidden = lump(dome(0.0, 0.0, 0.03, 0.1), false);
  REQUIRE(hidden);
  CHECK_FALSE(hidden->standing_on);
  CHECK_FALSE(hidden->seen[2]);
}

}  // namespace
}  // namespace quadrille

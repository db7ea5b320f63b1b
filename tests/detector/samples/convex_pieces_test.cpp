// Touching things come apart at the crease between them; single ones stay whole.
#include "samples/convex_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "support/catch.hpp"

namespace quadrille {
namespace {

constexpr double kCell = 0.005;

struct Ball {
  Eigen::Vector2d at;
  double radius;
};

/// The samples of balls of which the upper halves are seen from above, on a grid, each with its
/// eight neighbours. The normals are off by `noise` [rad].
SurfaceSamples seen_from_above(const std::vector<Ball>& balls, double noise = 0.0) {
  std::mt19937 random(5);
  std::normal_distribution<double> error(0.0, 1.0);
  SurfaceSamples samples;
  constexpr int kEdge = 60;
  std::vector<int> index(kEdge * kEdge, -1);
  for (int j = 0; j < kEdge; ++j) {
    for (int i = 0; i < kEdge; ++i) {
      const Eigen::Vector2d at(kCell * (i - 20), kCell * (j - 30));
      double height = -std::numeric_limits<double>::infinity();
      Eigen::Vector3d n;
      for (const Ball& ball : balls) {
        const double inside = ball.radius * ball.radius - (at - ball.at).squaredNorm();
        if (inside <= 0.0 || ball.radius + std::sqrt(inside) <= height) continue;
        height = ball.radius + std::sqrt(inside);
        n << at - ball.at, height - ball.radius;
      }
      if (!std::isfinite(height)) continue;
      for (double& x : n) x += noise * error(random) * n.norm();
      index[j * kEdge + i] = samples.size();
      samples.p.push_back(Eigen::Vector3d(at.x(), at.y(), height).cast<float>());
      samples.n.push_back(n.normalized().cast<float>());
    }
  }
  samples.first.push_back(0);
  for (int j = 0; j < kEdge; ++j) {
    for (int i = 0; i < kEdge; ++i) {
      if (index[j * kEdge + i] < 0) continue;
      for (int b = std::max(0, j - 1); b <= std::min(kEdge - 1, j + 1); ++b) {
        for (int a = std::max(0, i - 1); a <= std::min(kEdge - 1, i + 1); ++a) {
          if ((a != i || b != j) && index[b * kEdge + a] >= 0) {
            samples.neighbours.push_back(index[b * kEdge + a]);
          }
        }
      }
      samples.first.push_back(static_cast<int>(samples.neighbours.size()));
    }
  }
  return samples;
}

std::vector<std::vector<int>> pieces_of(const SurfaceSamples& samples) {
  std::vector<int> all(samples.size());
  std::iota(all.begin(), all.end(), 0);
  return convex_pieces(samples, all);
}

TEST_CASE("balls that touch each other are two pieces", "[bodies][pieces]") {
  for (const double noise : {0.0, 0.05}) {
    CAPTURE(noise);
    const SurfaceSamples samples =
        seen_from_above({{{0.0, 0.0}, 0.04}, {{0.07, 0.0}, 0.035}}, noise);
    const auto pieces = pieces_of(samples);
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].size() + pieces[1].size() == samples.p.size());
    for (std::size_t k = 0; k < 2; ++k) {
      const auto right = std::count_if(pieces[k].begin(), pieces[k].end(), [&](int i) {
        return (samples.p[i].x() < 0.037f) == (k == 0);
      });
      CHECK(right > 0.95 * static_cast<double>(pieces[k].size()));
    }
  }
}

TEST_CASE("a ball and a shallow bump on it are one piece", "[bodies][pieces]") {
  CHECK(pieces_of(seen_from_above({{{0.0, 0.0}, 0.05}})).size() == 1);
  CHECK(pieces_of(seen_from_above({{{0.0, 0.0}, 0.05}}, 0.05)).size() == 1);
  CHECK(pieces_of(seen_from_above({{{0.0, 0.0}, 0.05}, {{0.005, 0.0}, 0.048}})).size() == 1);
}

TEST_CASE("the inside of a bowl is one piece", "[bodies][pieces]") {
  SurfaceSamples bowl = seen_from_above({{{0.0, 0.0}, 0.08}});
  for (Eigen::Vector3f& p : bowl.p) p.z() *= -1.0f;
  for (Eigen::Vector3f& n : bowl.n) n.head<2>() *= -1.0f;
  CHECK(pieces_of(bowl).size() == 1);
}

TEST_CASE("no samples are lost, and pieces that do not touch stay apart", "[bodies][pieces]") {
  const SurfaceSamples samples = seen_from_above({{{0.0, 0.0}, 0.03}, {{0.1, 0.0}, 0.02}});
  const auto pieces = connected_pieces(samples, Mask(samples.p.size(), 1));
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].size() > pieces[1].size());
  CHECK(pieces[0].size() + pieces[1].size() == samples.p.size());
  CHECK(convex_pieces(samples, pieces[0]).size() == 1);
}

}  // namespace
}  // namespace quadrille

#include "search/grow.hpp"

#include <cmath>

#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kCell = 0.004;

InlierTest tolerance() {
  InlierTest test;
  test.sigmas = 3.0, test.cells = 0.1, test.min_cosine = 0.9;
  return test;
}

Quadric sphere_of(double radius) {
  return Quadric(Eigen::Matrix4d(Eigen::Vector4d(1, 1, 1, -radius * radius).asDiagonal()));
}

/// The samples within a ball about the middle of a square grid.
std::vector<int> middle(const SurfaceSamples& samples, float radius) {
  const int side = static_cast<int>(std::lround(std::sqrt(samples.size())));
  const Eigen::Vector3f centre = samples.p[(side / 2) * side + side / 2];
  std::vector<int> list;
  for (int i = 0; i < samples.size(); ++i) {
    if ((samples.p[i] - centre).norm() < radius) list.push_back(i);
  }
  return list;
}

std::optional<Candidate> grow(const SurfaceSamples& samples, const Quadric& hypothesis,
                              const std::vector<int>& start, const Mask& free,
                              const GrowOptions& options = {}) {
  Marks seen(free.size());
  return quadrille::grow(samples, hypothesis, start, free, tolerance(), options, &seen);
}

}  // namespace

TEST_CASE("a rough hypothesis grows over the whole sphere and takes its radius", "[grow]") {
  const double radius = 0.06;
  const SurfaceSamples samples = sphere_grid(24, 24, radius, kCell, 0.0005, 1);
  const std::vector<char> free(samples.p.size(), 1);
  const auto grown = grow(samples, sphere_of(1.02 * radius), middle(samples, 0.012f), free);
  REQUIRE(grown);
  CHECK(grown->family == Family::kSphere);
  CHECK(grown->region.size() > 0.97 * samples.p.size());
  CHECK(grown->rms == Approx(0.0005).epsilon(0.2));
  CHECK(canonical_form(grown->Q).dimensions.at(0).second == Approx(radius).epsilon(0.01));
}

TEST_CASE("a region keeps to the free samples that are connected", "[grow]") {
  const SurfaceSamples samples = sphere_grid(25, 25, 0.08, kCell, 0.0003, 2);
  std::vector<char> free(samples.p.size(), 1);
  // A gap of two columns parts the grid.
  for (int j = 0; j < 25; ++j) free[j * 25 + 18] = free[j * 25 + 19] = 0;
  const auto grown = grow(samples, sphere_of(0.08), middle(samples, 0.012f), free);
  REQUIRE(grown);
  CHECK(grown->region.size() > 0.97 * 25 * 18);
  for (const int i : grown->region) CHECK(i % 25 < 18);
}

TEST_CASE("without rounds a hypothesis collects its samples and stays as it is", "[grow]") {
  const SurfaceSamples samples = sphere_grid(24, 24, 0.06, kCell, 0.0005, 1);
  const std::vector<char> free(samples.p.size(), 1);
  GrowOptions options;
  options.rounds = 0;
  const Quadric hypothesis = sphere_of(1.02 * 0.06);
  const auto grown = grow(samples, hypothesis, middle(samples, 0.012f), free, options);
  REQUIRE(grown);
  CHECK(grown->Q.matrix() == hypothesis.matrix());
  CHECK(grown->family == Family::kGeneral);
  CHECK(static_cast<int>(grown->region.size()) >= options.min_samples);
}

TEST_CASE("a hypothesis without enough support does not grow", "[grow]") {
  const SurfaceSamples samples = sphere_grid(24, 24, 0.06, kCell, 0.0005, 3);
  const std::vector<char> free(samples.p.size(), 1), none(samples.p.size(), 0);
  const std::vector<int> start = middle(samples, 0.012f);
  CHECK_FALSE(grow(samples, sphere_of(0.2), start, free));
  CHECK_FALSE(grow(samples, sphere_of(0.06), start, none));
  GrowOptions greedy;
  greedy.min_samples = samples.size() + 1;
  CHECK_FALSE(grow(samples, sphere_of(0.06), start, free, greedy));
}

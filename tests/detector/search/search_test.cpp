#include "search/search.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::vector<Candidate> search_all(const SurfaceSamples& samples, std::uint64_t seed) {
  return search(samples, std::vector<char>(static_cast<std::size_t>(samples.size()), 1), {}, {},
                seed);
}

}  // namespace

TEST_CASE("the search finds a cylinder's and a sphere's samples and their quadric", "[search]") {
  constexpr double kRadius = 0.04;
  const SurfaceSamples cylinder = cylinder_grid(24, 30, kRadius, 0.004, 0.0005, 1);
  const SurfaceSamples sphere = sphere_grid(24, 24, kRadius, 0.004, 0.0005, 2);
  for (const SurfaceSamples* samples : {&cylinder, &sphere}) {
    const auto candidates = search_all(*samples, 1);
    REQUIRE_FALSE(candidates.empty());
    const Candidate& first = candidates[0];
    CHECK(first.region.size() > 0.9 * samples->size());
    CHECK(first.rms == Approx(0.0005).epsilon(0.3));
    double square = 0;
    for (const Eigen::Vector3f& p : samples->p)
      square += std::pow(first.Q.distance(p.cast<double>()), 2);
    CHECK(std::sqrt(square / samples->size()) < 0.0004);
  }
}

TEST_CASE("the regions hold open samples only, each once", "[search]") {
  const SurfaceSamples samples = cylinder_grid(24, 40, 0.04, 0.004, 0.0005, 3);
  std::vector<char> open(static_cast<std::size_t>(samples.size()), 1);
  for (int i = 0; i < samples.size(); ++i) open[static_cast<std::size_t>(i)] = i / 24 < 25;
  const auto candidates = search(samples, open, {}, {}, 1);
  REQUIRE_FALSE(candidates.empty());
  for (const Candidate& candidate : candidates) {
    const std::set<int> region(candidate.region.begin(), candidate.region.end());
    CHECK(region.size() == candidate.region.size());
    CHECK(candidate.region.size() >= static_cast<std::size_t>(SearchOptions().grow.min_samples));
    for (const int i : region) CHECK(open[static_cast<std::size_t>(i)]);
  }
}

TEST_CASE("a seed decides all, and nothing else does", "[search][determinism]") {
  const SurfaceSamples samples = sphere_grid(30, 30, 0.05, 0.004, 0.001, 4);
  const auto once = search_all(samples, 5), again = search_all(samples, 5);
  REQUIRE(once.size() == again.size());
  for (std::size_t k = 0; k < once.size(); ++k) {
    CHECK(once[k].Q.matrix() == again[k].Q.matrix());
    CHECK(once[k].region == again[k].region);
  }
}

TEST_CASE("several candidates explain a sample if that is asked", "[search]") {
  const SurfaceSamples samples = cylinder_grid(24, 40, 0.04, 0.004, 0.0005, 3);
  const std::vector<char> open(static_cast<std::size_t>(samples.size()), 1);
  const auto once = search(samples, open, {}, {}, 1);
  const auto thrice = search(samples, open, {}, {}, 1, {}, 3);
  CHECK(thrice.size() > once.size());
  std::vector<int> covers(open.size(), 0);
  for (const Candidate& candidate : thrice) {
    for (const int i : candidate.region) ++covers[static_cast<std::size_t>(i)];
  }
  const auto covered = std::count_if(covers.begin(), covers.end(), [](int n) { return n >= 3; });
  CHECK(static_cast<double>(covered) > 0.9 * samples.size());
}

TEST_CASE("without open samples or surfaces there are no candidates", "[search][degenerate]") {
  const SurfaceSamples samples = sphere_grid(20, 20, 0.05, 0.004, 0.0, 6);
  CHECK(search(samples, std::vector<char>(400, 0), {}, {}, 1).empty());
  CHECK(search_all(SurfaceSamples(), 1).empty());
  // Points and normals without any order.
  SurfaceSamples chaos = samples;
  RandomStream random(101, 0);
  for (int i = 0; i < chaos.size(); ++i) {
    const Eigen::Vector3d n(gaussian(random), gaussian(random), gaussian(random));
    chaos.n[i] = n.normalized().cast<float>();
    chaos.raw[i] += 0.03f * n.cast<float>();
  }
  CHECK(search_all(chaos, 1).empty());
}

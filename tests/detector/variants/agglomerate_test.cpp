#include "variants/agglomerate.hpp"

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

Candidate sphere_candidate(double radius, std::vector<int> region) {
  Candidate candidate;
  candidate.Q = Quadric(diagonal(1, 1, 1, -radius * radius));
  candidate.region = std::move(region);
  return candidate;
}

std::vector<int> half(const SurfaceSamples& samples, bool first) {
  std::vector<int> list;
  for (int i = 0; i < samples.size(); ++i) {
    if ((i < samples.size() / 2) == first) list.push_back(i);
  }
  return list;
}

}  // namespace

TEST_CASE("the far distance is the share of samples that lie not on both", "[agglomerate]") {
  const SurfaceSamples samples = sphere_grid(20, 20, 0.08, 0.004, 0.0003, 1);
  const std::vector<int> all = all_of(samples);
  InlierTest test;
  test.sigmas = 5.0;
  const Quadric sphere(diagonal(1, 1, 1, -0.0064)), other(diagonal(1, 1, 1, -0.01));
  CHECK(far_distance(sphere, sphere, samples, all, test) < 0.01);
  CHECK(far_distance(sphere, other, samples, all, test) == 1.0);
  CHECK(far_distance(sphere, sphere, samples, {}, test) == 1.0);
}

TEST_CASE("of the hypotheses of one surface the largest stays, other surfaces stay apart",
          "[agglomerate]") {
  const SurfaceSamples samples = sphere_grid(20, 20, 0.08, 0.004, 0.0003, 1);
  AgglomerateOptions options;
  std::vector<Candidate> candidates = {sphere_candidate(0.0801, half(samples, false)),
                                       sphere_candidate(0.0800, all_of(samples)),
                                       sphere_candidate(0.2, half(samples, true))};
  const auto kept = agglomerate(candidates, samples, InlierTest(), options);
  REQUIRE(kept.size() == 2);
  CHECK(kept[0].region.size() == samples.p.size());
  CHECK(kept[1].region.size() == samples.p.size() / 2);
}

#include "variants/variant.hpp"

#include "detector/table_scene.hpp"
#include "search/search.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "variants/measured_quantisation.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::vector<Candidate> search_with(const Propose& propose, const SurfaceSamples& samples) {
  return search(samples, std::vector<char>(static_cast<std::size_t>(samples.size()), 1), {}, {}, 1,
                propose);
}

void check_sphere(const Variant& variant, int bases) {
  const SurfaceSamples sphere = sphere_grid(24, 24, 0.04, 0.004, 0.0005, 2);
  const auto candidates = search_with(propose_variant(variant, bases), sphere);
  REQUIRE_FALSE(candidates.empty());
  CHECK(candidates[0].region.size() > 0.9 * sphere.size());
  CHECK(candidates[0].rms == Approx(0.0005).epsilon(0.3));
}

}  // namespace

TEST_CASE("a search that hashes its triplets counts them, and finds the same surface",
          "[variants][triplets]") {
  const SurfaceSamples samples = cylinder_grid(24, 30, 0.04, 0.004, 0.0005, 1);
  SearchOptions options;
  options.voters = 16;
  TripletSet seen;
  const auto candidates =
      search(samples, std::vector<char>(static_cast<std::size_t>(samples.size()), 1), options, {},
             1, propose_variant({.hash_triplets = true}, 2000, &seen));
  REQUIRE_FALSE(candidates.empty());
  CHECK(candidates[0].region.size() > 0.9 * samples.size());
  CHECK(seen.size() > 50);
  // Sixteen voters make 560 triplets.
  CHECK(seen.repeats() > seen.size());
}

TEST_CASE("agglomerated hypotheses find the same surface", "[variants][clusters]") {
  check_sphere({.lengths = GradientLengths::kSolved, .clusters = ClusterOptions()}, 5);
}

TEST_CASE("no more bases are drawn than the best surface so far takes", "[variants]") {
  check_sphere({.confidence = 0.95}, 1000);
  const SurfaceSamples sphere = sphere_grid(24, 24, 0.04, 0.004, 0.0005, 2);
  TripletSet all, some;
  search_with(propose_variant({}, 200, &all), sphere);
  search_with(propose_variant({.confidence = 0.95}, 200, &some), sphere);
  CHECK(some.size() > 0);
  CHECK(4 * some.size() < all.size());
}

TEST_CASE("the variant of the default detects the same bits as the detector", "[variants][law]") {
  const DetectionResult result = detect_variant(table_cloud(), {}, {});
  const auto& wanted = table_result().detections;
  REQUIRE(result.detections.size() == wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    CHECK(result.detections[k].Q_C.coefficients() == wanted[k].Q_C.coefficients());
    CHECK(result.detections[k].score == wanted[k].score);
  }
}

TEST_CASE("each variant finds the ball and the can of a table", "[variants]") {
  const Variant variants[] = {{.basis = VariantBasis::kTwoPoints},
                              {.basis = VariantBasis::kFourPoints},
                              {.basis = VariantBasis::kNinePoints},
                              {.lengths = GradientLengths::kSolved},
                              {.quantisation = kMeasured},
                              {.confidence = 0.95},
                              {.hash_triplets = true},
                              {.clusters = ClusterOptions()},
                              {.agglomerate = AgglomerateOptions()}};
  for (const Variant& variant : variants) {
    CAPTURE(&variant - variants);
    const DetectionResult result = detect_variant(table_cloud(), {}, variant);
    check_sound(result);
    const Detection* ball = find(result, QuadricType::kSphere);
    REQUIRE(ball);
    CHECK(dimension(*ball, "radius") == Approx(kBall).epsilon(0.02));
    CHECK(find(result, QuadricType::kCylinder));
  }
}

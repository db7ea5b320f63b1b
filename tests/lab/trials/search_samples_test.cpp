#include "lab/trials/search_samples.hpp"

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::trials {
namespace {

TEST_CASE("the search sees the balls, but not the wall behind them", "[trials]") {
  const auto found = search_samples(test::make_known_frame().cloud, {});
  REQUIRE(found);
  CHECK_FALSE(found->planes.empty());
  const SurfaceSamples& samples = found->tree->finest();
  REQUIRE(samples.size() > 100);
  int behind = 0;
  for (int i = 0; i < samples.size(); ++i) behind += samples.raw[i].z() > 1.4f;
  // What is left of the wall are cells at the outlines of the balls.
  CHECK(behind < 0.1 * samples.size());
}

TEST_CASE("a cloud without points has no samples", "[trials][degenerate]") {
  CHECK_FALSE(search_samples({}, {}));
}

}  // namespace
}  // namespace quadrille::trials

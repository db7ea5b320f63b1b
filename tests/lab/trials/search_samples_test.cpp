#include "lab/trials/search_samples.hpp"

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::trials {
namespace {

TEST_CASE("the search sees the balls, but not the wall behind them", "[trials]") {
  // Cells of one pixel: wider ones at the outlines of the balls hold points of the wall, too.
  DetectorOptions options;
  options.sampling.max_cells = 1'000'000;
  const auto found = search_samples(test::make_known_frame().cloud, options);
  REQUIRE(found);
  CHECK_FALSE(found->planes.empty());
  const SurfaceSamples& samples = found->tree->finest();
  REQUIRE(samples.size() > 100);
  int behind = 0;
  for (int i = 0; i < samples.size(); ++i) behind += samples.raw[i].z() > 1.4f;
  CHECK(behind < 0.02 * samples.size());
}

TEST_CASE("a cloud without points has no samples", "[trials][degenerate]") {
  CHECK_FALSE(search_samples({}, {}));
}

}  // namespace
}  // namespace quadrille::trials

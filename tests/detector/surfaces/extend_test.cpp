#include "surfaces/extend.hpp"

#include <algorithm>

#include "detector/pipe.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/surface_fit.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("a surface is extended over open samples near its ends, once each", "[extend]") {
  const SurfaceSamples samples = cylinder_grid(kPipeColumns, kPipeRows, 0.04, 0.004, 0.0005, 1);
  std::vector<int> middle;
  for (int i = 10 * kPipeColumns; i < 50 * kPipeColumns; ++i) middle.push_back(i);
  const auto piece = fit_surface(samples, middle, {});
  REQUIRE(piece);
  const SampleBlocks blocks(samples);
  const Extender extender(samples, blocks, {}, {});
  Mask free(samples.p.size(), 1);
  std::vector<int> region = extender.extended(*piece, free).region;
  // By a tenth and more at each end, and no farther than the margin.
  CHECK(region.size() > middle.size() * 12 / 10);
  CHECK(region.size() < middle.size() * 14 / 10);
  std::sort(region.begin(), region.end());
  CHECK(std::adjacent_find(region.begin(), region.end()) == region.end());
  // What is claimed above stays there.
  for (int i = 50 * kPipeColumns; i < samples.size(); ++i) free[static_cast<std::size_t>(i)] = 0;
  region = extender.extended(*piece, free).region;
  CHECK(region.size() > middle.size());
  CHECK(std::none_of(region.begin(), region.end(), [](int i) { return i >= 50 * kPipeColumns; }));
}

#include "views/joined_samples.hpp"

#include <algorithm>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3f;

namespace {

/// Samples of two views of the same small patch. Each is a neighbour of the one before it in its
/// own view.
SurfaceSamples two_views() {
  RandomStream random(5, 0);
  SurfaceSamples samples;
  samples.first.push_back(0);
  for (int i = 0; i < 3000; ++i) {
    const double x = random.uniform(), y = random.uniform();
    samples.raw.push_back(Vector3f(static_cast<float>(0.2 * x), static_cast<float>(0.2 * y), 1.0f));
    samples.cell.push_back(static_cast<float>(0.003 + 0.004 * random.uniform()));
    samples.view.push_back(i / 1500);
    if (i % 1500 > 0) samples.neighbours.push_back(i - 1);
    samples.first.push_back(static_cast<int>(samples.neighbours.size()));
  }
  samples.p = samples.n = samples.raw;
  return samples;
}

}  // namespace

TEST_CASE("samples of different views that lie within a cell of each other are linked", "[views]") {
  const SurfaceSamples samples = two_views();
  Mask some(samples.raw.size(), 1);
  for (std::size_t i = 0; i < some.size(); i += 3) some[i] = 0;
  const SurfaceSamples linked = linked_views(samples, some);
  int links = 0;
  for (int i = 0; i < samples.size(); ++i) {
    std::vector<int> expected;
    for (const int k : samples.neighbours_of(i)) expected.push_back(k);
    for (int j = 0; j < samples.size() && some[i]; ++j) {
      // The cell of the one that comes first counts.
      const float reach = samples.cell[std::min(i, j)];
      if (some[j] && samples.view[i] != samples.view[j] &&
          (samples.raw[i] - samples.raw[j]).squaredNorm() <= reach * reach) {
        expected.push_back(j);
        ++links;
      }
    }
    const auto found = linked.neighbours_of(i);
    CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
  }
  CHECK(links > 1000);
  const Mask none(samples.raw.size(), 0);
  CHECK(linked_views(samples, none).neighbours == samples.neighbours);
}

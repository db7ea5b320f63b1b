#include "views/place_cubes.hpp"

#include <algorithm>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3f;

namespace {

std::vector<Vector3f> places(int count) {
  RandomStream random(7, 0);
  std::vector<Vector3f> places;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    places.emplace_back(Eigen::Vector3d(0.4 * x - 0.2, 0.3 * y - 0.1, 0.1 * z - 0.3).cast<float>());
  }
  return places;
}

}  // namespace

TEST_CASE("all places nearer than a reach are found, whatever the edge of the cubes", "[views]") {
  const std::vector<Vector3f> all = places(2000);
  std::size_t most = 0;
  for (const float edge : {0.005f, 0.02f, 0.3f}) {
    const PlaceCubes cubes(all, edge);
    for (std::size_t i = 0; i < all.size(); i += 50) {
      for (const float reach : {0.002f, 0.02f, 0.07f}) {
        const Vector3f p = all[i] + Vector3f(0.001f, -0.002f, 0.0f);
        std::vector<int> expected, found = cubes.near(p, reach);
        for (int k = 0; k < static_cast<int>(all.size()); ++k) {
          if ((all[k] - p).squaredNorm() < reach * reach) expected.push_back(k);
        }
        std::sort(found.begin(), found.end());
        CHECK(found == expected);
        most = std::max(most, found.size());
      }
    }
  }
  CHECK(most > 100);
}

TEST_CASE("no place is found among none, or far from all", "[views]") {
  const std::vector<Vector3f> none, all = places(10);
  CHECK(PlaceCubes(none, 1.0f).near(Vector3f::Zero(), 10.0f).empty());
  CHECK(PlaceCubes(all, 0.01f).near(Vector3f(1e9f, 0.0f, 0.0f), 0.02f).empty());
}

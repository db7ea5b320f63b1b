#include "contacts/finger_runs.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

struct SlicePoint {
  float y = 0.0f, z = 0.0f;
};

/// One depth after the other, by the definition of a run.
std::vector<Run> runs_at(const std::vector<SlicePoint>& points, float tip, float root, float gap) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!(points[k].z < tip && points[k].z > root)) continue;
    if (runs.empty() || points[k].y - points[runs.back().last].y > gap) runs.push_back({k, k});
    runs.back().last = k;
  }
  return runs;
}

}  // namespace

TEST_CASE("runs at all depths are those found at one depth after the other", "[contacts][points]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> along(0.0f, 0.2f), height(-0.05f, 0.05f);
  const std::array tips = {0.04f, 0.02f, 0.01f, 0.0f, -0.02f};
  std::array<float, 5> roots{};
  std::transform(tips.begin(), tips.end(), roots.begin(), [](float tip) { return tip - 0.03f; });
  constexpr float kGap = 0.01f;
  FingerRuns found(kGap);
  std::size_t most = 0;
  for (const std::size_t count : {0u, 1u, 5u, 60u, 400u}) {
    std::vector<SlicePoint> points;
    for (std::size_t k = 0; k < count; ++k) points.push_back({along(random), height(random)});
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    // Every other of the sorted points belongs to the slice.
    std::vector<float> y, z;
    std::vector<std::uint32_t> places;
    for (const SlicePoint& point : points) {
      y.insert(y.end(), {point.y, 0.0f}), z.insert(z.end(), {point.z, 0.0f});
      places.push_back(static_cast<std::uint32_t>(2 * places.size()));
    }
    found.find({.exact_y = nullptr, .y = y.data(), .z = z.data(), .index = {}}, places, tips,
               roots);
    for (std::size_t n = 0; n < tips.size(); ++n) {
      const std::vector<Run> expected = runs_at(points, tips[n], roots[n], kGap);
      REQUIRE(found.at(n).size() == expected.size());
      for (std::size_t r = 0; r < expected.size(); ++r) {
        CHECK(found.at(n)[r].first == expected[r].first);
        CHECK(found.at(n)[r].last == expected[r].last);
      }
      most = std::max(most, expected.size());
    }
  }
  CHECK(most > 5);
}

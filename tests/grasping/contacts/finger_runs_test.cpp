#include "contacts/finger_runs.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// One depth after the other, by the definition of a run.
std::vector<Run> runs_at(const std::vector<InSlice>& points, float tip, float root, float gap) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!(points[k].z < tip && points[k].z > root)) continue;
    if (runs.empty() || points[k].y - points[runs.back().last].y > gap) runs.push_back({k, k, 0});
    runs.back().last = k;
    ++runs.back().count;
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
    std::vector<InSlice> points;
    for (std::size_t k = 0; k < count; ++k) {
      points.push_back({along(random), height(random), static_cast<std::uint32_t>(k)});
    }
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    found.find(points, tips, roots);
    for (std::size_t n = 0; n < tips.size(); ++n) {
      const std::vector<Run> expected = runs_at(points, tips[n], roots[n], kGap);
      REQUIRE(found.at(n).size() == expected.size());
      for (std::size_t r = 0; r < expected.size(); ++r) {
        CHECK(found.at(n)[r].first == expected[r].first);
        CHECK(found.at(n)[r].last == expected[r].last);
        CHECK(found.at(n)[r].count == expected[r].count);
      }
      most = std::max(most, expected.size());
    }
  }
  CHECK(most > 5);
}

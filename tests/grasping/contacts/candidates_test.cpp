#include "contacts/candidates.hpp"

#include <algorithm>
#include <cstddef>

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("the best approach comes first and the first pass spans the whole ranking",
          "[candidates]") {
  std::vector<ContactLine> lines(40);
  for (std::size_t n = 0; n < lines.size(); ++n) {
    lines[n].closing_C = Eigen::Vector3d::UnitX();
    lines[n].centre_C = {0.0, 0.0, 0.002 * static_cast<double>(n)};
  }
  ApproachSpace space;
  space.view_C = -Eigen::Vector3d::UnitZ();
  const auto [candidates, unreachable, unwanted] = sample_approaches(lines, space);
  REQUIRE(candidates.size() > 160);
  CHECK(candidates.size() + unreachable == 24 * lines.size());
  CHECK(unwanted == 0);
  const auto [worst, best] =
      std::minmax_element(candidates.begin(), candidates.end(),
                          [](const auto& a, const auto& b) { return a.prior < b.prior; });
  CHECK(candidates.front().prior == best->prior);
  const std::size_t pass = (candidates.size() + 15) / 16;
  CHECK(candidates[pass - 1].prior < worst->prior + 0.1 * (best->prior - worst->prior));
  CHECK(candidates[pass].prior > best->prior - 0.1 * (best->prior - worst->prior));
}

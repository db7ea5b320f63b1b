#include "lab/study/wilson.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace quadrille::study;

TEST_CASE("the ends of a Wilson interval solve the equation that defines it", "[study]") {
  // |p̂ − p| = z √(p(1 − p)/n) at both ends.
  for (const auto& [counted, of] : {std::pair{3, 10}, {1, 2}, {94, 100}, {8, 81}}) {
    CAPTURE(counted, of);
    const Share share = wilson_share(counted, of);
    CHECK(share.value == Approx(static_cast<double>(counted) / of));
    for (const double end : {share.low, share.high}) {
      const double away = std::abs(share.value - end) / std::sqrt(end * (1.0 - end) / of);
      CHECK(away == Approx(1.959963985).epsilon(1e-8));
    }
    CHECK(share.low < share.value);
    CHECK(share.high > share.value);
  }
}

TEST_CASE("the Wilson interval of none or all keeps to 0 and 1", "[study]") {
  // z² / (n + z²) of nothing counted, with z² = 3.841459.
  const Share none = wilson_share(0, 10), all = wilson_share(10, 10);
  CHECK(none.low == 0.0);
  CHECK(none.high == Approx(3.841459 / 13.841459).epsilon(1e-6));
  CHECK(all.high == Approx(1.0));
  CHECK(all.low == Approx(10.0 / 13.841459).epsilon(1e-6));
  const Share unknown = wilson_share(0, 0);
  CHECK(unknown.low == 0.0);
  CHECK(unknown.high == 1.0);
}

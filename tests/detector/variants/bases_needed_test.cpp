#include "variants/bases_needed.hpp"

#include <cmath>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("the bases needed are those after which a good one was drawn so often",
          "[bases_needed]") {
  RandomStream random(3, 0);
  for (const double w : {0.5, 0.7, 0.9}) {
    for (const int k : {1, 3, 4}) {
      const double n = bases_needed(w, k, 0.95);
      const auto share_after = [&](int bases) {
        constexpr int kRounds = 4000;
        int good = 0;
        for (int round = 0; round < kRounds; ++round) {
          bool any = false;
          for (int b = 0; b < bases && !any; ++b) {
            bool all = true;
            for (int point = 0; point < k; ++point) all &= random.uniform() < w;
            any = all;
          }
          good += any;
        }
        return static_cast<double>(good) / kRounds;
      };
      CAPTURE(w, k, n);
      CHECK(share_after(static_cast<int>(n)) > 0.935);
      if (n > 1.0) CHECK(share_after(static_cast<int>(n) - 1) < 0.965);
    }
  }
  CHECK(bases_needed(1.0, 3, 0.95) == 1.0);
  CHECK(std::isinf(bases_needed(0.0, 3, 0.95)));
}

#include "base/random.hpp"

#include <array>
#include <set>

#include "support/catch.hpp"

using quadrille::RandomStream;

TEST_CASE("from state zero the stream is the published SplitMix64 sequence", "[random]") {
  // Start values whose mixes vanish: the state is 0, as in the reference program with seed 0.
  RandomStream random(0 - 0x9e3779b97f4a7c15u, 0 - 0xd1b54a32d192ed03u);
  CHECK(random.next() == 0xe220a8397b1dcdafu);
  CHECK(random.next() == 0x6e789e6aa1b965f4u);
  CHECK(random.next() == 0x06c45d188009454fu);
}

TEST_CASE("integers below n are in range and equally frequent", "[random]") {
  RandomStream random(3, 1);
  std::array<int, 6> count{};
  for (int i = 0; i < 60000; ++i) {
    const int k = random.below(6);
    REQUIRE(k >= 0);
    REQUIRE(k < 6);
    ++count[static_cast<std::size_t>(k)];
  }
  double chi_square = 0;
  for (const int n : count) chi_square += (n - 10000.0) * (n - 10000.0) / 10000.0;
  CHECK(chi_square < 20.5);  // 99.9 % quantile for 5 degrees of freedom
  CHECK(RandomStream(1, 1).below(1) == 0);
  RandomStream wide(5, 5);
  for (int i = 0; i < 1000; ++i) CHECK(wide.below(2147483647) >= 0);
}

TEST_CASE("reals are from 0 up to 1 with the mean and variance of the uniform distribution",
          "[random]") {
  RandomStream random(4, 0);
  double sum = 0, square = 0;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.uniform();
    REQUIRE(x >= 0.0);
    REQUIRE(x < 1.0);
    sum += x;
    square += x * x;
  }
  const double mean = sum / kCount;
  CHECK(mean == Approx(0.5).margin(0.004));
  CHECK(square / kCount - mean * mean == Approx(1.0 / 12.0).margin(0.002));
}

TEST_CASE("each seed and each trial has a stream of its own, the same each time",
          "[random][determinism]") {
  std::set<std::uint64_t> firsts;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    for (std::uint64_t trial = 0; trial < 30; ++trial) {
      RandomStream random(seed, trial), again(seed, trial);
      const std::uint64_t first = random.next();
      CHECK(first == again.next());
      firsts.insert(first);
    }
  }
  CHECK(firsts.size() == 900);
}

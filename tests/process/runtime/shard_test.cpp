#include "process/runtime/shard.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "support/catch.hpp"

namespace quadrille {
namespace {

/// A message of that size, all zero but for one number.
std::vector<std::byte> message(std::size_t size, std::size_t at, std::uint64_t number) {
  std::vector<std::byte> bytes(size);
  std::memcpy(bytes.data() + at, &number, sizeof number);
  return bytes;
}

TEST_CASE("each message is exactly one shard's, and shards have like shares", "[process][shard]") {
  // Times 33,333 us apart, as of a camera; and clouds of one time that differ in a point. Of 40,000
  // bytes every 72nd is looked at from the 256th on.
  const std::size_t at = GENERATE(8, 256 + 72 * 440);
  const int count = GENERATE(1, 2, 3, 8);
  std::vector<int> taken(static_cast<std::size_t>(count));
  constexpr int kMessages = 2000;
  for (int i = 0; i < kMessages; ++i) {
    const auto bytes = message(40'000, at, 1'700'000'000'000'000 + 33'333ull * i);
    int takers = 0;
    for (int index = 1; index <= count; ++index) {
      if (!Shard{index, count}.takes(bytes)) continue;
      ++takers;
      ++taken[static_cast<std::size_t>(index - 1)];
    }
    REQUIRE(takers == 1);
  }
  for (const int share : taken) {
    CHECK(share > 0.8 * kMessages / count);
    CHECK(share < 1.2 * kMessages / count);
  }
}

TEST_CASE("a shard is written I/N and names its channels", "[process][shard]") {
  const Shard shard = parse_shard("2/3");
  CHECK(shard.index == 2);
  CHECK(shard.count == 3);
  CHECK(shard.channel("QUADRICS") == "QUADRICS_2");
  CHECK(Shard{}.channel("QUADRICS") == "QUADRICS");
  for (const char* bad : {"", "1", "0/2", "3/2", "1/0", "-1/2", "1/65", "1/2x", "a/b", "1//2"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(parse_shard(bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace quadrille

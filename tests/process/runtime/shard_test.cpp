#include "process/runtime/shard.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "quadrille/bus/cloud_message.hpp"
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
  // Times 33,333 us apart, as of a camera; and clouds of one time that differ in one point,
  // wherever that is.
  const std::size_t at = GENERATE(8, 31'937, 40'000 - 8);
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

/// Which of so many shards takes a cloud.
int taker_of(std::int32_t seq, int count) {
  bus::CloudMessage cloud;
  cloud.utime = 1'700'000'000'000'000 + 33'333ll * seq;
  cloud.seq = seq;
  cloud.cloud.points.resize(3, Eigen::Vector3f::Ones());
  cloud.cloud.width = 3;
  cloud.cloud.height = 1;
  cloud.cloud.read = 3;
  const auto bytes = bus::encode_cloud(cloud, bus::CloudFormat::kPointCloud2);
  int taker = 0;
  for (int index = 1; index <= count; ++index) {
    if (!Shard{index, count}.takes(bytes)) continue;
    REQUIRE(taker == 0);
    taker = index;
  }
  REQUIRE(taker != 0);
  return taker;
}

TEST_CASE("clouds that have a number are dealt out in turns", "[process][shard]") {
  // Every cloud of the source, and every second or third alone.
  const int step = GENERATE(1, 2, 3);
  const int count = GENERATE(2, 3, 4, 8);
  std::vector<int> taken(static_cast<std::size_t>(count));
  int last = 0, run = 0, longest = 0;
  constexpr int kClouds = 2400;
  for (int i = 1; i <= kClouds; ++i) {
    const int taker = taker_of(i * step, count);
    ++taken[static_cast<std::size_t>(taker - 1)];
    run = taker == last ? run + 1 : 1;
    last = taker;
    longest = std::max(longest, run);
  }
  CHECK(longest <= 4);
  if (step == 1) CHECK(longest <= 2);
  for (const int share : taken) CHECK(std::abs(share - kClouds / count) <= 12);
}

TEST_CASE("a source that does not count has its clouds dealt out all the same",
          "[process][shard]") {
  const std::size_t size = 2000;
  int first = 0;
  for (int i = 0; i < 1000; ++i) {
    bus::CloudMessage cloud;
    cloud.utime = i;
    cloud.cloud.points.resize(size / 12, Eigen::Vector3f::Ones());
    cloud.cloud.width = static_cast<int>(size / 12);
    cloud.cloud.height = 1;
    cloud.cloud.read = size / 12;
    first += Shard{1, 2}.takes(bus::encode_cloud(cloud, bus::CloudFormat::kPointCloud2)) ? 1 : 0;
  }
  CHECK(first > 400);
  CHECK(first < 600);
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

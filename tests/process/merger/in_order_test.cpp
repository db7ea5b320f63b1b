#include "process/merger/in_order.hpp"

#include <algorithm>

#include "support/catch.hpp"

namespace quadrille {
namespace {

using std::chrono::milliseconds;
const InOrder::Clock::time_point kStart{};

InOrder::Bytes bytes(int value) { return {static_cast<std::byte>(value)}; }

std::vector<int> values(const std::vector<InOrder::Bytes>& messages) {
  std::vector<int> all;
  for (const auto& message : messages) all.push_back(std::to_integer<int>(message.at(0)));
  return all;
}

TEST_CASE("results of shards go out in the order of their clouds", "[process][shard]") {
  InOrder results(2, milliseconds(100));
  results.add(0, 1, 0, bytes(1), kStart);
  results.add(0, 3, 0, bytes(3), kStart);
  results.add(1, 2, 0, bytes(2), kStart);
  // Until the second shard has spoken of 3 or later, it may yet tell something earlier.
  CHECK(values(results.take(kStart)) == std::vector<int>{1, 2});
  results.add(1, 4, 0, bytes(4), kStart);
  CHECK(values(results.take(kStart)) == std::vector<int>{3});
  CHECK(values(results.take(kStart + milliseconds(100))) == std::vector<int>{4});
  CHECK(results.merged() == 4);
  CHECK(results.late() == 0);
}

TEST_CASE("a shard that is lost holds the others up once", "[process][shard]") {
  InOrder results(2, milliseconds(100));
  results.add(0, 1, 0, bytes(1), kStart);
  results.add(1, 2, 0, bytes(2), kStart);
  results.add(0, 3, 0, bytes(3), kStart);
  CHECK(values(results.take(kStart)) == std::vector<int>{1, 2});
  CHECK(results.take(kStart + milliseconds(99)).empty());
  CHECK(values(results.take(kStart + milliseconds(100))) == std::vector<int>{3});
  results.add(0, 4, 0, bytes(4), kStart + milliseconds(101));
  CHECK(values(results.take(kStart + milliseconds(101))) == std::vector<int>{4});
  // It is back, with something that is too late and something that is not.
  results.add(1, 3, 5, bytes(9), kStart + milliseconds(102));
  results.add(1, 5, 0, bytes(5), kStart + milliseconds(102));
  results.add(0, 6, 0, bytes(6), kStart + milliseconds(102));
  CHECK(values(results.take(kStart + milliseconds(102))) == std::vector<int>{5});
  CHECK(results.late() == 1);
}

TEST_CASE("clouds may begin anew, and no result goes out twice", "[process][shard]") {
  InOrder results(1, milliseconds(100));
  for (const int time : {5, 6, 6}) results.add(0, time, 0, bytes(time), kStart);
  CHECK(values(results.take(kStart)) == std::vector<int>{5, 6});
  CHECK(results.late() == 1);
  results.add(0, 1, 0, bytes(1), kStart);
  CHECK(values(results.take(kStart)) == std::vector<int>{1});
}

TEST_CASE("what waits is bounded", "[process][shard][hostile]") {
  InOrder results(2, std::chrono::hours(1));
  results.add(1, 0, 0, bytes(0), kStart);
  std::size_t out = 0;
  for (int i = 1; i <= 10'000; ++i) {
    results.add(0, i, 0, bytes(i % 100), kStart);
    out += results.take(kStart).size();
  }
  CHECK(out >= 10'000 - InOrder::kMaxWaiting);
}

}  // namespace
}  // namespace quadrille

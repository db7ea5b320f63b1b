#include "process/merger/in_order.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <random>

#include "support/catch.hpp"

namespace quadrille {
namespace {

using std::chrono::milliseconds;
const InOrder::Clock::time_point kStart{};

InOrder::Bytes bytes(int value) { return {static_cast<std::byte>(value)}; }

std::vector<int> values(const std::vector<InOrder::Result>& results) {
  std::vector<int> all;
  for (const auto& result : results) all.push_back(std::to_integer<int>(result.message.at(0)));
  return all;
}

/// A cloud of which the shards tell, known by one number.
struct Told {
  int number;
  int owner;
  std::int64_t utime;

  std::int64_t digest() const { return 1000 + number; }
  void see(int shard, InOrder* results) const {
    results->see(shard, {utime, 0}, 5000 + number, shard == owner ? digest() : 0);
  }
  void answer(InOrder* results, InOrder::Clock::time_point now = kStart) const {
    results->add(owner, {utime, 0}, digest(), bytes(number), now);
  }
};

TEST_CASE("results of shards go out in the order of their clouds", "[process][shard]") {
  InOrder results(2, milliseconds(100));
  results.add(0, {1, 0}, 1, bytes(1), kStart);
  results.add(0, {3, 0}, 3, bytes(3), kStart);
  results.add(1, {2, 0}, 2, bytes(2), kStart);
  // Until the second shard has spoken of 3 or later, it may yet tell something earlier.
  CHECK(values(results.take(kStart)) == std::vector<int>{1, 2});
  results.add(1, {4, 0}, 4, bytes(4), kStart);
  CHECK(values(results.take(kStart)) == std::vector<int>{3});
  CHECK(values(results.take(kStart + milliseconds(100))) == std::vector<int>{4});
  CHECK(results.merged() == 4);
  CHECK(results.late() == 0);
}

TEST_CASE("results that wait take a bounded memory, and the oldest goes first",
          "[process][shard][hostile]") {
  InOrder results(2, std::chrono::hours(1));
  // The second shard holds all up: it took a cloud before them.
  Told{0, 1, 0}.see(1, &results);
  Told{0, 1, 0}.see(0, &results);
  constexpr std::size_t kSize = 16 << 20;
  std::vector<int> out;
  std::size_t waiting = 0;
  for (int n = 1; n <= 20; ++n) {
    results.add(0, {n, 0}, n, InOrder::Bytes(kSize, static_cast<std::byte>(n)), kStart);
    waiting += kSize;
    for (const int value : values(results.take(kStart))) {
      out.push_back(value);
      waiting -= kSize;
    }
    CHECK(waiting <= InOrder::kMaxWaitingBytes);
  }
  REQUIRE(out.size() == 16);
  for (int n = 0; n < 16; ++n) CHECK(out[static_cast<std::size_t>(n)] == n + 1);
}

TEST_CASE("where all have told of a cloud its result waits for nobody", "[process][shard]") {
  const std::int64_t step = GENERATE(0, 1000);
  InOrder results(2, std::chrono::hours(1));
  for (int n = 1; n <= 5; ++n) {
    const Told cloud{n, 0, n * step};
    for (const int shard : {1, 0}) cloud.see(shard, &results);
    cloud.answer(&results);
    CHECK(values(results.take(kStart)) == std::vector<int>{n});
  }
  // The other one's turn: what comes after it is answered first, and waits.
  const Told others{6, 1, 6 * step}, next{7, 0, 7 * step};
  for (const Told& cloud : {others, next}) {
    for (const int shard : {0, 1}) cloud.see(shard, &results);
  }
  next.answer(&results);
  CHECK(results.take(kStart).empty());
  others.answer(&results);
  CHECK(values(results.take(kStart)) == std::vector<int>{6, 7});
  CHECK(results.late() == 0);
}

TEST_CASE("clouds that are alike in all are answered one by one", "[process][shard]") {
  InOrder results(2, std::chrono::hours(1));
  const Told still{1, 0, 0};
  for (int i = 0; i < 3; ++i) {
    for (const int shard : {0, 1}) still.see(shard, &results);
  }
  for (int i = 0; i < 3; ++i) {
    still.answer(&results);
    CHECK(values(results.take(kStart)) == std::vector<int>{1});
  }
  // More answers than clouds: somebody answers twice.
  still.answer(&results);
  CHECK(results.take(kStart).empty());
  CHECK(results.late() == 1);
}

TEST_CASE("a cloud that its shard passed over holds nobody up", "[process][shard]") {
  InOrder results(2, std::chrono::hours(1));
  const Told dropped{1, 0, 0}, others{2, 1, 0}, newer{3, 0, 0};
  for (const Told& cloud : {dropped, others, newer}) {
    for (const int shard : {0, 1}) cloud.see(shard, &results);
  }
  others.answer(&results);
  CHECK(results.take(kStart).empty());
  newer.answer(&results);
  CHECK(values(results.take(kStart)) == std::vector<int>{2, 3});
  CHECK(results.unanswered() == 1);
}

TEST_CASE("a shard of which nothing is known yet may answer the first cloud", "[process][shard]") {
  InOrder results(2, std::chrono::hours(1));
  const Told first{1, 1, 10}, second{2, 0, 20};
  first.see(0, &results);
  CHECK(results.take(kStart).empty());
  first.see(1, &results);
  second.see(0, &results);
  second.answer(&results);
  CHECK(results.take(kStart).empty());
  first.answer(&results);
  second.see(1, &results);
  CHECK(values(results.take(kStart)) == std::vector<int>{1, 2});
}

TEST_CASE("a shard that is lost holds the others up once", "[process][shard]") {
  InOrder results(2, milliseconds(100));
  results.add(0, {1, 0}, 1, bytes(1), kStart);
  results.add(1, {2, 0}, 2, bytes(2), kStart);
  results.add(0, {3, 0}, 3, bytes(3), kStart);
  CHECK(values(results.take(kStart)) == std::vector<int>{1, 2});
  CHECK(results.take(kStart + milliseconds(99)).empty());
  CHECK(values(results.take(kStart + milliseconds(100))) == std::vector<int>{3});
  CHECK(results.state(1) == InOrder::State::kSilent);
  results.add(0, {4, 0}, 4, bytes(4), kStart + milliseconds(101));
  CHECK(values(results.take(kStart + milliseconds(101))) == std::vector<int>{4});
  // It is back, with something that is too late and something that is not.
  results.add(1, {3, 5}, 9, bytes(9), kStart + milliseconds(102));
  CHECK(results.state(1) == InOrder::State::kWorks);
  results.add(1, {5, 0}, 5, bytes(5), kStart + milliseconds(102));
  results.add(0, {6, 0}, 6, bytes(6), kStart + milliseconds(102));
  CHECK(values(results.take(kStart + milliseconds(102))) == std::vector<int>{5});
  CHECK(results.late() == 1);
}

TEST_CASE("a shard that comes back tells of what comes now", "[process][shard]") {
  InOrder results(2, milliseconds(100));
  const Told still{1, 0, 0};
  auto now = kStart;
  still.see(1, &results);
  for (int i = 0; i < 20; ++i, now += milliseconds(100)) {
    still.see(0, &results);
    still.answer(&results, now);
    results.take(now + milliseconds(100));
  }
  CHECK(results.state(1) == InOrder::State::kSilent);
  for (int i = 0; i < 5; ++i) {
    for (const int shard : {0, 1}) still.see(shard, &results);
    still.answer(&results, now);
    CHECK(values(results.take(now)) == std::vector<int>{1});
  }
}

TEST_CASE("a shard that takes clouds and does not answer holds the others up once",
          "[process][shard]") {
  InOrder results(2, milliseconds(100));
  std::vector<Told> clouds;
  for (int n = 0; n < 4; ++n) {
    clouds.push_back({n, n % 2, 0});
    for (const int shard : {0, 1}) clouds.back().see(shard, &results);
  }
  clouds[0].answer(&results);
  clouds[2].answer(&results);
  CHECK(values(results.take(kStart)) == std::vector<int>{0});
  CHECK(values(results.take(kStart + milliseconds(100))) == std::vector<int>{2});
  CHECK(results.state(1) == InOrder::State::kStuck);
  const Told later{4, 0, 0};
  for (const int shard : {0, 1}) later.see(shard, &results);
  later.answer(&results, kStart + milliseconds(101));
  CHECK(values(results.take(kStart + milliseconds(101))) == std::vector<int>{4});
  // Its answers come at last, after later ones.
  clouds[1].answer(&results, kStart + milliseconds(102));
  clouds[3].answer(&results, kStart + milliseconds(102));
  CHECK(results.take(kStart + milliseconds(102)).empty());
  CHECK(results.late() == 2);
  CHECK(results.state(1) == InOrder::State::kWorks);
}

TEST_CASE("what a shard tells of a cloud may be lost or come late", "[process][shard]") {
  InOrder results(2, std::chrono::hours(1));
  const Told first{1, 0, 10}, second{2, 1, 20}, third{3, 0, 30};
  first.see(1, &results);
  first.answer(&results);
  CHECK(values(results.take(kStart)) == std::vector<int>{1});
  first.see(0, &results);
  // Of the second only its answer comes.
  second.answer(&results);
  CHECK(results.take(kStart).empty());
  third.see(0, &results);
  CHECK(values(results.take(kStart)) == std::vector<int>{2});
  CHECK(results.late() == 0);
}

TEST_CASE("clouds may begin anew, and no result goes out twice", "[process][shard]") {
  InOrder results(1, milliseconds(100));
  for (const int time : {5, 6, 6}) results.add(0, {time, 0}, time, bytes(time), kStart);
  CHECK(values(results.take(kStart)) == std::vector<int>{5, 6});
  CHECK(results.late() == 1);
  for (const int time : {1, 5, 6}) results.add(0, {time, 0}, time, bytes(time), kStart);
  CHECK(values(results.take(kStart)) == std::vector<int>{1, 5, 6});
  CHECK(results.late() == 1);
}

TEST_CASE("what waits is bounded", "[process][shard][hostile]") {
  const bool is_answered = GENERATE(true, false);
  InOrder results(2, std::chrono::hours(1));
  results.add(1, {0, 0}, 1, bytes(0), kStart);
  std::size_t out = 0;
  for (int i = 1; i <= 10'000; ++i) {
    const Told cloud{i % 100, 0, i};
    cloud.see(0, &results);
    if (is_answered) cloud.answer(&results);
    out += results.take(kStart).size();
  }
  if (is_answered) {
    CHECK(out >= 10'000 - InOrder::kMaxWaiting);
  } else {
    CHECK(results.unanswered() >= 9'000);
  }
}

/// When what a shard tells arrives: in its order, each some time after its cause.
class Wire {
 public:
  double arrival(double sent, double delay) { return last_ = std::max(last_, sent + delay); }

 private:
  double last_ = 0.0;
};

TEST_CASE("whatever the delays, each cloud that is answered goes out once and in order",
          "[process][shard][law]") {
  const bool tells_time = GENERATE(true, false);
  // Every tenth of what shards tell of clouds that are not theirs is lost; what comes is there
  // before the next cloud.
  const bool is_lossy = GENERATE(false, true);
  std::mt19937 random(7);
  const auto below = [&](double most) {
    return most * static_cast<double>(random() % 10'000) / 10'000.0;
  };
  for (int round = 0; round < 50; ++round) {
    constexpr int kClouds = 100;
    const int shards = 2 + static_cast<int>(random() % 3);
    InOrder results(shards, std::chrono::hours(1));
    std::multimap<double, std::function<void()>> events;
    std::vector<Wire> wires(static_cast<std::size_t>(shards));
    std::vector<double> busy_until(static_cast<std::size_t>(shards), 0.0);
    std::vector<int> expected;
    for (int n = 0; n < kClouds; ++n) {
      // Nothing but the number tells clouds apart where there is no time; some are quite alike.
      const int number = tells_time || is_lossy ? n : n / 2;
      const Told cloud{number, static_cast<int>(random() % static_cast<unsigned>(shards)),
                       tells_time ? n + 1 : 0};
      for (int shard = 0; shard < shards; ++shard) {
        const auto which = static_cast<std::size_t>(shard);
        const double told = wires[which].arrival(n, below(is_lossy ? 0.9 : 3.0));
        const bool is_lost =
            is_lossy && shard != cloud.owner && n + 1 < kClouds && random() % 10 == 0;
        if (!is_lost) events.emplace(told, [=, &results] { cloud.see(shard, &results); });
        if (shard != cloud.owner) continue;
        busy_until[which] = std::max(busy_until[which], told) + below(5.0);
        events.emplace(busy_until[which], [=, &results] { cloud.answer(&results); });
      }
      expected.push_back(cloud.number);
    }
    std::vector<int> out;
    for (const auto& [when, event] : events) {
      event();
      for (const int number : values(results.take(kStart))) out.push_back(number);
    }
    CHECK(out == expected);
    CHECK(results.late() == 0);
  }
}

}  // namespace
}  // namespace quadrille

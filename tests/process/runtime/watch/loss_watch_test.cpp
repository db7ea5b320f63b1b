#include "process/runtime/watch/loss_watch.hpp"

#include "support/catch.hpp"

namespace quadrille {
namespace {

using std::chrono::seconds;

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bus::Traffic traffic(std::int64_t message, std::int64_t buffer, std::int64_t dropped) {
  bus::Traffic traffic;
  traffic.largest_message = message;
  traffic.asked_buffer = 1 << 30;
  traffic.receive_buffer = buffer;
  traffic.dropped_datagrams = dropped;
  return traffic;
}

TEST_CASE("losses are told at once, then at a bounded rate", "[process][network]") {
  LossWatch watch;
  const LossWatch::Clock::time_point start;
  // Eight messages of this size need more than 512 MiB. No Linux grants 1 GiB, whatever
  // net.core.rmem_max is.
  constexpr std::int64_t kLarge = 100000000;
  CHECK(!watch.check(traffic(kLarge, 32 << 20, 0), start));
  const auto first = watch.check(traffic(kLarge, 32 << 20, 431), start + seconds(1));
  REQUIRE(first);
  CHECK(says(*first, "431 datagrams, at most as many messages, were lost"));
  CHECK(says(*first, "sudo sysctl -w net.core.rmem_max=1073741824"));
  CHECK(!watch.check(traffic(kLarge, 32 << 20, 500), start + seconds(2)));
  const auto later = watch.check(traffic(kLarge, 32 << 20, 500), start + seconds(12));
  REQUIRE(later);
  CHECK(says(*later, "500 datagrams"));
  CHECK(!watch.check(traffic(kLarge, 32 << 20, 500), start + seconds(60)));
}

TEST_CASE("what the filter refuses is no loss and has no advice on buffers", "[process][network]") {
  LossWatch watch;
  const LossWatch::Clock::time_point start;
  bus::Traffic filtered = traffic(1000, 32 << 20, 0);
  filtered.filtered_datagrams = 40;
  const auto told = watch.check(filtered, start);
  REQUIRE(told);
  CHECK(says(*told, "40 datagrams were refused by the filter"));
  CHECK(says(*told, "--accept-from"));
  CHECK_FALSE(says(*told, "mend it with"));
  CHECK(LossWatch::find_warnings(filtered, {}).empty());
  // They come all the time where strangers share the network.
  filtered.filtered_datagrams = 4000;
  CHECK(!watch.check(filtered, start + seconds(300)));
  // What is lost is told at once all the same.
  filtered.dropped_datagrams = 3;
  CHECK(says(watch.check(filtered, start + seconds(301)).value(), "3 datagrams, at most"));
}

TEST_CASE("where the cause is unclear both are told, and no cure", "[process][network]") {
  bus::Traffic unclear = traffic(1000, 32 << 20, 0);
  unclear.unclear_datagrams = 4;
  const auto warnings = LossWatch::find_warnings(unclear, {});
  REQUIRE(warnings.size() == 1);
  CHECK(says(warnings[0], "4 datagrams were lost because"));
  CHECK(says(warnings[0], "or refused by the filter"));
  CHECK_FALSE(says(warnings[0], "sysctl"));
}

TEST_CASE("messages driven out are told with their cause", "[process][network]") {
  LossWatch watch;
  bus::Traffic driven_out = traffic(1000, 32 << 20, 0);
  driven_out.dropped_messages = 5;
  const auto told = watch.check(driven_out);
  REQUIRE(told);
  CHECK(says(*told, "5 messages were driven out"));
  CHECK(LossWatch::find_warnings(driven_out, {}).size() == 1);
}

TEST_CASE("warnings judge the buffer by the messages that came", "[process][network]") {
  const std::vector<std::string> at_start = {"too small for a usual cloud"};
  CHECK(LossWatch::find_warnings(traffic(0, 212992, 0), at_start) == at_start);
  // The clouds turned out to be small.
  CHECK(LossWatch::find_warnings(traffic(58000, 212992, 0), at_start).empty());
  const auto large = LossWatch::find_warnings(traffic(8600000, 4 << 20, 0), {});
  REQUIRE(large.size() == 1);
  CHECK(says(large[0], "too small for messages of 8600000 bytes"));
  const auto lost = LossWatch::find_warnings(traffic(8600000, 4 << 20, 431), {});
  REQUIRE(lost.size() == 1);
  CHECK(says(lost[0], "431 datagrams"));
  CHECK(says(lost[0], "mend it with: "));
}

TEST_CASE("at the end all losses are told, or none", "[process][network]") {
  CHECK(LossWatch::describe(traffic(8600000, 4 << 20, 0)).empty());
  // The system does not tell.
  CHECK(LossWatch::describe(traffic(8600000, 4 << 20, -1)).empty());
  CHECK(says(LossWatch::describe(traffic(8600000, 4 << 20, 9)), "9 datagrams"));
}

}  // namespace
}  // namespace quadrille

#include "process/merger/merger.hpp"

#include <map>

#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

using Bytes = std::vector<std::byte>;

/// A merger whose messages are kept.
struct Merge {
  Merger merger{{}, [this](const std::string& channel, std::span<const std::byte> bytes) {
                  published[channel].emplace_back(bytes.begin(), bytes.end());
                }};
  std::map<std::string, std::vector<Bytes>> published;

  void see(int shard, std::int64_t digest, std::int32_t of = 2, std::int64_t sender = 1) {
    shard_cloud_t message{};
    message.message_digest = digest;
    message.cloud_digest = digest;
    message.shard = shard + 1;
    message.shards = of;
    message.sender = sender + 10 * shard;
    merger.receive_seen(shard, "SEEN", bus::encode(message));
  }

  Bytes answer(int shard, std::int64_t digest) {
    bus::CloudMessage cloud;
    cloud.digest = digest;
    const Bytes bytes = bus::encode(bus::to_message(cloud, DetectionResult{}));
    merger.receive_result(shard, "QUADRICS_1", bytes);
    return bytes;
  }

  merger_status_t status() {
    merger.publish_status({}, {});
    merger_status_t status{};
    const Bytes& bytes = published["QUADRILLE_MERGER_STATUS"].back();
    REQUIRE(status.decode(bytes.data(), 0, static_cast<int>(bytes.size())) > 0);
    return status;
  }
};

bool is_warned_of(const merger_status_t& status, const std::string& part) {
  for (const std::string& warning : status.warnings) {
    if (warning.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST_CASE("results go on as they came, and the status counts them", "[process][shard][status]") {
  Merge merge;
  merge.see(0, 7);
  merge.see(1, 8);
  const Bytes bytes = merge.answer(0, 7);
  merge.merger.receive_result(1, "QUADRICS_2", Bytes(30));
  merge.see(1, 9);
  merge.merger.publish_due();
  CHECK(merge.published["QUADRICS"] == std::vector<Bytes>{bytes});
  const merger_status_t status = merge.status();
  CHECK(status.received == 2);
  CHECK(status.published == 1);
  CHECK(status.published_bytes == static_cast<std::int64_t>(bytes.size()));
  REQUIRE(status.rejected.size() == 1);
  CHECK(status.rejected[0].name == "unknown_type");
  REQUIRE(status.shards.size() == 2);
  CHECK(status.shards[0].state == "works");
  CHECK(status.shards[0].results == 1);
  CHECK(status.shards[1].clouds == 2);
  CHECK(status.warnings.empty());
  const std::string text = merge.merger.publish_status({}, {});
  const auto holds = [&](const std::string& line) { return text.find(line) != std::string::npos; };
  CHECK(
      holds("quadrille_merger_results_published_total{channel=\"QUADRICS\","
            "status_channel=\"QUADRILLE_MERGER_STATUS\"} 1\n"));
  CHECK(
      holds("quadrille_merger_shard_works{channel=\"QUADRICS\","
            "status_channel=\"QUADRILLE_MERGER_STATUS\",shard=\"2\"} 1\n"));
}

TEST_CASE("a detector of another number of shards is told of", "[process][shard]") {
  Merge merge;
  merge.see(0, 7, 3);
  CHECK(is_warned_of(merge.status(), "the detector on QUADRICS_1 has --shard 1/3"));
  merge.see(0, 8, 2);
  CHECK(merge.status().warnings.empty());
}

TEST_CASE("two detectors of one share have no cloud answered twice", "[process][shard]") {
  Merge merge;
  merge.see(1, 1);
  for (std::int64_t digest = 2; digest < 10; ++digest) {
    merge.see(1, digest);
    for (const std::int64_t sender : {5, 6}) {
      merge.see(0, digest, 2, sender);
      merge.answer(0, digest);
    }
  }
  merge.see(1, 100);
  merge.merger.publish_due();
  CHECK(merge.published["QUADRICS"].size() <= 8);
  // One that is started anew is nobody's twin.
  CHECK(merge.status().late >= 7);
}

TEST_CASE("a message that is no shard's is refused", "[process][shard][hostile]") {
  Merge merge;
  merge.merger.receive_seen(0, "SEEN", Bytes(51));
  merge.see(0, 1, 0);
  CHECK(merge.status().rejected.size() == 2);
}

TEST_CASE("a loss and a return are told once, and at a bounded rate", "[process][shard]") {
  using State = InOrder::State;
  using std::chrono::seconds;
  const ShardWatch::Clock::time_point start{seconds(100)};
  ShardWatch watch(2, 3, "QUADRICS_2");
  CHECK_FALSE(watch.update(State::kUnheard, {}, start + seconds(60)));
  CHECK_FALSE(watch.update(State::kUnheard, start, start + seconds(2)));
  const auto unheard = watch.update(State::kUnheard, start, start + seconds(3));
  REQUIRE(unheard);
  CHECK(unheard->find("shard 2/3 was not heard on QUADRICS_2") == 0);
  CHECK_FALSE(watch.update(State::kUnheard, start, start + seconds(4)));
  CHECK(watch.describe());
  CHECK(watch.update(State::kWorks, start, start + seconds(5)) == "shard 2/3 is back");
  CHECK_FALSE(watch.describe());
  // It comes and goes.
  int records = 0;
  for (int s = 20; s < 60; ++s) {
    const State state = s % 2 ? State::kWorks : State::kSilent;
    if (watch.update(state, start, start + seconds(s))) ++records;
  }
  CHECK(records >= 2);
  CHECK(records <= 8);
  CHECK(watch.times_lost() == 21);
}

}  // namespace
}  // namespace quadrille

#include "doctor/traffic.hpp"

#include <lcmtypes/bot_core/pose_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/quadrics_t.hpp>

#include "datagrams.hpp"
#include "doctor/check_traffic.hpp"
#include "doctor/datagram.hpp"
#include "support/catch.hpp"

namespace quadrille::doctor {
namespace {

using test::fragment;
using test::kNow;
using test::kSecond;
using test::short_message;

const auto kCloud = [] { return drake::lcmt_point_cloud::getHash(); };

bool holds(const Findings& findings, Verdict verdict, const std::string& part) {
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& found) {
    return found.verdict == verdict && found.what.find(part) != std::string::npos;
  });
}

TEST_CASE("messages that never came are counted by sender", "[doctor]") {
  Traffic traffic;
  for (const std::uint32_t sequence : {7u, 8u, 11u, 12u}) {
    traffic.add("a:1", short_message(sequence, "X", 1, 0), kNow);
  }
  traffic.add("b:1", short_message(5000, "X", 1, 0), kNow);
  CHECK(traffic.senders().at("a:1").messages == 4);
  CHECK(traffic.senders().at("a:1").missing == 2);
  CHECK(traffic.senders().at("b:1").missing == 0);
  CHECK(check_losses(traffic, 7667).verdict == Verdict::kFailed);
}

TEST_CASE("the counter of messages may pass 2^32 and start anew", "[doctor]") {
  Traffic traffic;
  for (const std::uint32_t sequence : {0xfffffffeu, 0xffffffffu, 0u, 1u}) {
    traffic.add("a:1", short_message(sequence, "X", 1, 0), kNow);
  }
  CHECK(traffic.senders().at("a:1").missing == 0);
}

TEST_CASE("a message of which a datagram is missing is incomplete", "[doctor]") {
  Traffic traffic;
  for (const std::uint32_t sequence : {1u, 2u, 3u}) {
    for (const std::uint32_t number : {0u, 1u, 2u}) {
      if (sequence == 2 && number == 1) continue;
      traffic.add("a:1", fragment(sequence, 3000, 1000 * number, number, 3), kNow);
    }
  }
  CHECK(traffic.senders().at("a:1").incomplete == 1);
  CHECK(traffic.senders().at("a:1").missing == 0);
  CHECK(traffic.largest_cloud() == 3000);
}

TEST_CASE("datagrams that LCM would not take, or die of, are counted and never read", "[doctor]") {
  Traffic traffic;
  std::vector<test::Bytes> bad(5);
  bad[1].number(0x4c433032, 4);
  bad[2].number(0x4c433039, 4).number(1, 4).name("X");
  bad[3].number(0x4c433032, 4).number(1, 4).number(0x4141, 2);
  bad[4] = fragment(1, 3000, 0xffffffff, 1, 3);
  for (const test::Bytes& bytes : bad) traffic.add("a:1", bytes, kNow);
  CHECK(traffic.malformed() == 5);
  CHECK(traffic.streams().empty());
  const Finding found = check_losses(traffic, 7700);
  CHECK(found.verdict == Verdict::kWarning);
  CHECK(found.remedy.find("udp port 7700;") != std::string::npos);
}

TEST_CASE("no number of senders takes more than a bounded memory", "[doctor][hostile]") {
  Traffic traffic;
  for (std::size_t i = 0; i < Traffic::kMaxStreams + 100; ++i) {
    traffic.add(std::to_string(i), short_message(1, "X", 1, 0), kNow);
  }
  CHECK(traffic.senders().size() == Traffic::kMaxStreams);
  CHECK(traffic.crowded_out() == 100);
}

TEST_CASE("two detectors at one time are told, one that was started anew is not", "[doctor]") {
  const std::int64_t type = quadrics_t::getHash();
  Traffic twins, restarted;
  for (int i = 0; i < 4; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const std::string sender = i % 2 == 0 ? "a:1" : "b:1";
    twins.add(sender, short_message(number / 2, "QUADRICS", type, i + 1), kNow + i);
    restarted.add(i < 2 ? "a:1" : "b:1", short_message(number, "QUADRICS", type, i + 1), kNow + i);
  }
  CHECK(holds(check_others(twins, "POINT_CLOUD"), Verdict::kFailed, "2 detectors answer"));
  CHECK_FALSE(has_failure(check_others(restarted, "POINT_CLOUD")));
}

TEST_CASE("processes that meet on several channels are one finding", "[doctor]") {
  Traffic twins;
  for (const auto& [channel, type] : {std::pair("QUADRICS", quadrics_t::getHash()),
                                      std::pair("STATUS", detector_status_t::getHash())}) {
    for (const char* sender : {"a:1", "b:1", "a:1"}) {
      twins.add(sender, short_message(1, channel, type, kNow), kNow);
    }
  }
  const Findings findings = check_others(twins, "POINT_CLOUD");
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].what == "2 detectors answer on QUADRICS, STATUS: a:1, b:1");
  CHECK(findings[0].remedy.find("--out-channel, --status-channel") != std::string::npos);
}

TEST_CASE("two who send clouds or poses on one channel are told", "[doctor]") {
  for (const auto& [type, what] :
       {std::pair(kCloud(), "2 send clouds on R2/C: a:1, b:1"),
        std::pair(bot_core::pose_t::getHash(), "2 send poses on R2/C")}) {
    Traffic traffic;
    for (const char* sender : {"a:1", "b:1", "a:1"}) {
      traffic.add(sender, short_message(1, "R2/C", type, kNow), kNow);
    }
    CHECK(holds(check_others(traffic, "POINT_CLOUD"), Verdict::kWarning, what));
    CHECK_FALSE(has_failure(check_others(traffic, "POINT_CLOUD")));
  }
}

TEST_CASE("clouds are looked for on the channels of a pattern", "[doctor]") {
  Traffic traffic;
  traffic.add("a:1", short_message(1, "R2/CAM_A", kCloud(), kNow), kNow);
  CHECK(check_clouds(traffic, "R2/(CAM_.*)", 1.0, "R2/").verdict == Verdict::kOk);
  const auto advice = [&](const std::string& prefix) {
    return check_clouds(traffic, prefix + "C", 1.0, prefix).remedy;
  };
  CHECK(
      advice("R2/") ==
      "quadrille-detector --in-channel CAM_A, quadrille-grasp-planner --cloud-channel CAM_A, with "
      "--channel-prefix R2/");
  CHECK(advice("R3/").find("--in-channel R2/CAM_A") != std::string::npos);
  CHECK(advice("R3/").find("without --channel-prefix R3/") != std::string::npos);
}

TEST_CASE("types that share a channel are told, clouds of several types are not", "[doctor]") {
  Traffic clash;
  clash.add("a:1", short_message(1, "POINT_CLOUD", kCloud(), kNow), kNow);
  CHECK_FALSE(has_failure(check_others(clash, "POINT_CLOUD")));
  clash.add("b:1", short_message(1, "POINT_CLOUD", 42, kNow), kNow);
  CHECK(holds(check_others(clash, "POINT_CLOUD"), Verdict::kFailed, "2 types on POINT_CLOUD"));
}

TEST_CASE("clouds on another channel than the one looked at are told with it", "[doctor]") {
  Traffic traffic;
  CHECK(check_clouds(traffic, "POINT_CLOUD", 1.0).verdict == Verdict::kWarning);
  traffic.add("a:1", short_message(1, "CAMERA", kCloud(), kNow), kNow);
  const Finding found = check_clouds(traffic, "POINT_CLOUD", 1.0);
  CHECK(found.verdict == Verdict::kFailed);
  CHECK(found.remedy.find("--in-channel CAMERA") != std::string::npos);
  CHECK(check_clouds(traffic, "CAMERA", 1.0).verdict == Verdict::kOk);
}

TEST_CASE("times that are off, zero or do not grow are told", "[doctor]") {
  Traffic good, off, zero, stale;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::int64_t now = kNow + i * kSecond;
    good.add("a:1", short_message(i, "C", kCloud(), now - 30'000), now);
    off.add("a:1", short_message(i, "S", detector_status_t::getHash(), now + 5 * kSecond), now);
    zero.add("a:1", short_message(i, "C", kCloud(), 0), now);
    stale.add("a:1", short_message(i, "C", kCloud(), kNow), kNow + i);
  }
  CHECK(holds(check_clocks(good, kNow), Verdict::kOk, ""));
  CHECK(check_clocks(good, kNow).size() == 1);
  CHECK(holds(check_clocks(off, kNow), Verdict::kWarning, "5.0 s ahead of"));
  CHECK(holds(check_clocks(zero, kNow), Verdict::kWarning, "3 of 3 messages have utime 0"));
  CHECK(holds(check_clocks(stale, kNow), Verdict::kWarning, "did not grow from 2 of 3"));
  CHECK(has_failure(check_clocks(good, 3 * kSecond)));
}

}  // namespace
}  // namespace quadrille::doctor

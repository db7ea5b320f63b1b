#include "doctor/pose_recorder.hpp"

#include <lcmtypes/bot_core/pose_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <limits>

#include "datagrams.hpp"
#include "quadrille/bus/pose_message.hpp"
#include "support/catch.hpp"

namespace quadrille::doctor {
namespace {

using test::kNow;

PoseRecorder make_recorder() { return {"POSE", "POINT_CLOUD", kNow}; }

test::Bytes pose_datagram(const std::string& channel, std::int64_t utime) {
  bus::PoseMessage pose;
  pose.utime = utime;
  return test::whole_message(1, channel, bus::encode_pose(pose));
}

test::Bytes cloud_datagram(const std::string& channel, std::int64_t utime) {
  return test::short_message(1, channel, drake::lcmt_point_cloud::getHash(), utime);
}

TEST_CASE("poses and clouds are recorded with their times and those of their arrival",
          "[doctor][pose]") {
  PoseRecorder recorder = make_recorder();
  recorder.add("a:1", pose_datagram("POSE", kNow + 1), kNow + 5);
  recorder.add("b:1", cloud_datagram("POINT_CLOUD", kNow + 2), kNow + 6);
  recorder.add("b:1", cloud_datagram("OTHER_CLOUD", kNow + 3), kNow + 7);
  recorder.add("a:1", pose_datagram("HAND_POSE", kNow + 4), kNow + 8);
  const PoseArrivals heard = recorder.heard(kNow + 9);
  REQUIRE(heard.poses.size() == 1);
  CHECK(heard.poses[0].utime == kNow + 1);
  CHECK(heard.poses[0].at == kNow + 5);
  REQUIRE(heard.clouds.size() == 1);
  CHECK(heard.clouds[0].utime == kNow + 2);
  CHECK(heard.clouds[0].at == kNow + 6);
  CHECK(heard.other_channels == std::set<std::string>{"HAND_POSE"});
  CHECK(heard.refused == 0);
  CHECK(heard.begin == kNow);
  CHECK(heard.end == kNow + 9);
}

TEST_CASE("a cloud arrives with its last fragment, and one without it does not arrive",
          "[doctor][pose]") {
  PoseRecorder recorder = make_recorder();
  for (const std::uint32_t sequence : {1u, 2u, 3u}) {
    for (const std::uint32_t number : {0u, 1u, 2u}) {
      if (sequence == 2 && number == 1) continue;
      recorder.add("a:1", test::fragment(sequence, 3000, 1000 * number, number, 3),
                   kNow + 10 * sequence + number);
    }
  }
  const PoseArrivals heard = recorder.heard(kNow);
  REQUIRE(heard.clouds.size() == 2);
  CHECK(heard.clouds[0].at == kNow + 12);
  CHECK(heard.clouds[1].at == kNow + 32);
}

TEST_CASE("messages on the channel of poses that are none are counted with the reason",
          "[doctor][pose][hostile]") {
  PoseRecorder recorder = make_recorder();
  recorder.add("a:1", cloud_datagram("POSE", kNow), kNow);
  CHECK(recorder.heard(kNow).refusal.detail == "not bot_core.pose_t");
  bus::PoseMessage wrong;
  wrong.X_WC.translation().x() = std::numeric_limits<double>::quiet_NaN();
  recorder.add("a:1", test::whole_message(2, "POSE", bus::encode_pose(wrong)), kNow);
  const PoseArrivals heard = recorder.heard(kNow);
  CHECK(heard.refused == 2);
  CHECK(heard.refusal.reason == bus::RejectReason::kBadValue);
  CHECK(heard.poses.empty());
  CHECK(heard.clouds.empty());
}

TEST_CASE("without a channel of poses nothing is recorded", "[doctor][pose]") {
  PoseRecorder recorder("", "POINT_CLOUD", kNow);
  recorder.add("a:1", pose_datagram("POSE", kNow), kNow);
  recorder.add("a:1", cloud_datagram("POINT_CLOUD", kNow), kNow);
  CHECK(recorder.heard(kNow).other_channels.empty());
  CHECK(recorder.heard(kNow).clouds.empty());
}

TEST_CASE("of very many poses the last ones are kept, and no clouds from before them",
          "[doctor][pose][hostile]") {
  PoseRecorder recorder = make_recorder();
  recorder.add("b:1", cloud_datagram("POINT_CLOUD", kNow), kNow);
  const auto most = static_cast<std::int64_t>(PoseRecorder::kMaxArrivals);
  for (std::int64_t i = 0; i < most + 10; ++i) {
    recorder.add("a:1", pose_datagram("POSE", kNow + i), kNow + i);
  }
  recorder.add("b:1", cloud_datagram("POINT_CLOUD", kNow), kNow + most);
  const PoseArrivals heard = recorder.heard(kNow);
  CHECK(heard.poses.size() == PoseRecorder::kMaxArrivals);
  CHECK(heard.poses.front().at == kNow + 10);
  REQUIRE(heard.clouds.size() == 1);
  CHECK(heard.clouds[0].at == kNow + most);
}

TEST_CASE("senders and names without end take no more than a bounded memory",
          "[doctor][pose][hostile]") {
  PoseRecorder recorder = make_recorder();
  for (std::size_t i = 0; i < 10 * PoseRecorder::kMaxParts; ++i) {
    recorder.add(std::to_string(i), test::fragment(1, 3000, 0, 0, 3), kNow);
    recorder.add("a:1", pose_datagram("POSE_" + std::to_string(i), kNow), kNow);
  }
  CHECK(recorder.heard(kNow).other_channels.size() == PoseRecorder::kMaxNames);
  recorder.add("0", test::fragment(1, 3000, 1000, 1, 3), kNow);
  recorder.add("0", test::fragment(1, 3000, 2000, 2, 3), kNow);
  CHECK(recorder.heard(kNow).clouds.empty());
}

}  // namespace
}  // namespace quadrille::doctor

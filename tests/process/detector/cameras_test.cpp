// Several cameras on one channel, or on the channels of a pattern.
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "process/detector/detector_process.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

using test::Bytes;
using test::camera_at;
using test::encode_view;
using Process = test::DetectorProcess;

TEST_CASE("two cameras on one channel have tracks of their own", "[process][track]") {
  Process both{DetectorSettings{}}, alone{DetectorSettings{}};
  // One sees the ball and the wall, the other the wall alone, from elsewhere, and in turns.
  for (int frame = 1; frame <= 4; ++frame) {
    const std::int64_t utime = 100000 * frame;
    both.take("POINT_CLOUD", encode_view(utime, camera_at(0), "left"));
    alone.take("POINT_CLOUD", encode_view(utime, camera_at(0), "left"));
    CHECK(both.published.back() == alone.published.back());
    both.take("POINT_CLOUD", encode_view(utime, camera_at(1), "right"));
    CHECK(both.tracks() == std::set<int>{1, 2});
  }
}

TEST_CASE("a pattern serves several cameras, each with channels and tracks of its own",
          "[process][pattern]") {
  DetectorSettings settings;
  settings.in_channel = "CAMERA_.*";
  std::map<std::string, std::vector<Bytes>> published;
  DetectorNode node(settings, [&](const std::string& channel, std::span<const std::byte> bytes) {
    published[channel].emplace_back(bytes.begin(), bytes.end());
  });
  Process alone{DetectorSettings{}};
  for (const std::string side : {"LEFT", "RIGHT"}) {
    for (int frame = 0; frame < 2; ++frame) {
      const Bytes bytes = encode_view(100000 * (frame + 1), camera_at(frame), "camera");
      const auto job = node.receive("CAMERA_" + side, bytes);
      REQUIRE(job);
      // Only newer clouds of the same camera take its place.
      CHECK(job->kind == "CAMERA_" + side);
      node.work(*job);
      if (side == "LEFT") alone.take("POINT_CLOUD", bytes);
    }
    CHECK(published["QUADRICS_CAMERA_" + side] == alone.published);
    CHECK(published["BOXES_CAMERA_" + side].size() == 2);
  }
  CHECK_FALSE(node.receive("CAMERA", encode_view(1, camera_at(0))));
}

TEST_CASE("cameras that share a frame's name miss nothing of each other's",
          "[process][pattern][status]") {
  DetectorSettings settings;
  settings.in_channel = "CAMERA_.*";
  Process process(settings);
  const auto take = [&](const std::string& channel, int seq) {
    bus::CloudMessage message{
        1000 * seq, seq,
        test::render({test::rectangle(test::translation(0, 0, 1.0), 2, 2)}, {16, 12, 1.0 / 15.0})};
    message.cloud.frame = "camera";
    process.node.receive(channel, bus::encode_cloud(message, bus::CloudFormat::kPointCloud2));
  };
  for (int n = 0; n < 4; ++n) {
    take("CAMERA_LEFT", 10 + n);
    take("CAMERA_RIGHT", 5000 + n);
  }
  process.node.publish_status({});
  CHECK(process.status.missing == 0);
  take("CAMERA_RIGHT", 5006);
  process.node.publish_status({});
  CHECK(process.status.missing == 2);
}

TEST_CASE("results of a pattern begin with the prefix of all channels once", "[process][pattern]") {
  DetectorSettings settings;
  settings.process.channel_prefix = "robot.2/";
  settings.in_channel = settings.process.prefixed("CAMERA_.*");
  settings.out_channel = settings.process.prefixed(settings.out_channel);
  std::set<std::string> channels;
  DetectorNode node(settings, [&](const std::string& channel, std::span<const std::byte>) {
    channels.insert(channel);
  });
  const Bytes cloud = encode_view(1, camera_at(0));
  // A dot of the prefix stands for itself.
  CHECK_FALSE(node.receive("robotX2/CAMERA_LEFT", cloud));
  const auto job = node.receive("robot.2/CAMERA_LEFT", cloud);
  REQUIRE(job);
  node.work(*job);
  CHECK(channels.contains("robot.2/QUADRICS_CAMERA_LEFT"));
  CHECK(ProcessArguments{}.prefixed("CAMERA_.*") == "CAMERA_.*");
}

TEST_CASE("a pattern takes no results for clouds, and no more cameras than it can serve",
          "[process][pattern][hostile]") {
  DetectorSettings settings;
  settings.in_channel = ".*";
  DetectorNode node(settings, [](const std::string&, std::span<const std::byte>) {});
  const Bytes cloud = encode_view(1, camera_at(0));
  for (const char* own : {"QUADRICS_A", "BOXES_A", "QUADRICS", "QUADRILLE_DETECTOR_STATUS"}) {
    CHECK_FALSE(node.receive(own, cloud));
  }
  CHECK_FALSE(node.receive(std::string(60, 'A'), cloud));
  CHECK(node.summary().find("clouds in: 1, 1 refused (bad_channel 1)") == 0);
  for (std::size_t n = 0; n < Trackers::kMaxTrackers; ++n) {
    CHECK(node.receive("A" + std::to_string(n), cloud));
  }
  CHECK_FALSE(node.receive("ONE_MORE", cloud));
  CHECK(node.receive("A0", cloud));
  CHECK(node.summary().find("2 refused (bad_channel 2)") != std::string::npos);
}

}  // namespace
}  // namespace quadrille

#include "process/detector/node.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "process/detector/command_line.hpp"
#include "process/encode_pose.hpp"
#include "process/logged_lines.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

using Bytes = std::vector<std::byte>;
using test::encode_pose;

/// A detector process whose messages are kept.
struct Process {
  explicit Process(const DetectorSettings& settings)
      : node(settings, [this](const std::string& channel, std::span<const std::byte> bytes) {
          last[channel].assign(bytes.begin(), bytes.end());
          if (channel == "QUADRICS") published.emplace_back(bytes.begin(), bytes.end());
          if (channel == "QUADRILLE_DETECTOR_STATUS") {
            status.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
          }
        }) {}

  void take(const std::string& channel, const Bytes& bytes, std::int64_t now = 0) {
    for (const Job& job : node.take(Node::Time(now), channel, bytes)) node.work(job);
  }
  /// Does what has waited until now.
  void pass(std::int64_t now) {
    for (const Job& job : node.find_due_jobs(Node::Time(now))) node.work(job);
  }

  /// The tracks of the last message.
  std::set<int> tracks() const {
    std::set<int> found;
    const auto decoded = bus::decode_quadrics(published.back());
    for (const Detection& d : std::get<bus::QuadricsMessage>(decoded).detections) {
      found.insert(d.track);
    }
    return found;
  }

  /// What the status says of the clouds that were not tracked, such as "no_pose 1 ".
  std::string untracked() {
    node.publish_status({});
    std::string text;
    for (const count_t& entry : status.untracked) {
      text += entry.name + " " + std::to_string(entry.count) + " ";
    }
    return text;
  }

  /// The tracks of the bodies of the last cloud.
  std::set<int> body_tracks() const {
    std::set<int> found;
    const auto decoded = bus::decode_body_tracks(last.at("BODY_TRACKS"));
    for (const auto& [id, track] : std::get<bus::BodyTracksMessage>(decoded).track_of) {
      found.insert(track);
    }
    return found;
  }

  std::vector<Bytes> published;
  /// The last message of each channel.
  std::map<std::string, Bytes> last;
  detector_status_t status{};
  DetectorNode node;
};

/// A ball before a wall, both at rest in W, as a camera at X_WC sees them.
Bytes encode_view(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                  const std::string& frame = "") {
  const Eigen::Isometry3d X_CW = X_WC.inverse();
  bus::CloudMessage message{utime, 0, {}};
  message.cloud = test::render({test::sphere(X_CW * test::translation(0, 0, 0.9), 0.1),
                                test::rectangle(X_CW * test::translation(0, 0, 1.4), 9, 9)},
                               {160, 120, 1.0 / 150.0});
  message.cloud.frame = frame;
  return bus::encode_cloud(message, bus::CloudFormat::kDrake);
}

TEST_CASE("clouds in millimetres give quadrics in metres", "[process]") {
  bus::CloudMessage message{1, 0, {}};
  message.cloud = test::render({test::sphere(test::translation(0, 0, 0.9), 0.1),
                                test::rectangle(test::translation(0, 0, 1.4), 9, 9)},
                               {160, 120, 1.0 / 150.0});
  for (Eigen::Vector3f& p : message.cloud.points) p *= 1000.0f;
  DetectorSettings settings;
  settings.frames.unit = 1e-3;
  Process process(settings);
  process.take("POINT_CLOUD", bus::encode_cloud(message, bus::CloudFormat::kDrake));
  const auto decoded = bus::decode_quadrics(process.published.back());
  bool found = false;
  for (const Detection& d : std::get<bus::QuadricsMessage>(decoded).detections) {
    if (d.type == QuadricType::kSphere) found = std::abs(d.dimension(0) - 0.1) < 2e-3;
  }
  CHECK(found);
}

DetectorSettings settings_with_poses() {
  DetectorSettings settings;
  settings.pose_channel = "CAMERA";
  return settings;
}

// Each step is more than the ball is wide.
Eigen::Isometry3d camera_at(int frame) {
  return test::translation(frame % 2 ? 0.3 : -0.3, 0.02 * frame, 0.0);
}

TEST_CASE("with its poses, a camera that jumps about keeps the tracks of what is at rest",
          "[process][track][pose]") {
  Process process(settings_with_poses()), blind{DetectorSettings{}};
  bool lost = false;
  for (int frame = 0; frame < 5; ++frame) {
    const std::int64_t utime = 100000 * (frame + 1);
    // The camera jumps where no cloud is taken.
    process.take("CAMERA", encode_pose(utime - 3, camera_at(frame)));
    process.take("POINT_CLOUD", encode_view(utime, camera_at(frame)));
    CHECK(process.published.size() == static_cast<std::size_t>(frame));
    process.take("CAMERA", encode_pose(utime + 1, camera_at(frame)));
    process.take("CAMERA", encode_pose(utime + 2, camera_at(frame + 1)));
    blind.take("POINT_CLOUD", encode_view(utime, camera_at(frame)));
    CHECK(process.tracks() == std::set<int>{1, 2});
    lost = lost || blind.tracks() != std::set<int>{1, 2};
  }
  CHECK(process.node.find_oddities().empty());
  CHECK(lost);
}

TEST_CASE("with its poses, a camera that jumps about keeps the tracks of bodies",
          "[process][track][bodies][pose]") {
  Process process(settings_with_poses());
  for (int frame = 0; frame < 5; ++frame) {
    const std::int64_t utime = 100000 * (frame + 1);
    process.take("CAMERA", encode_pose(utime - 1, camera_at(frame)));
    process.take("POINT_CLOUD", encode_view(utime, camera_at(frame)));
    process.take("CAMERA", encode_pose(utime + 1, camera_at(frame)));
    // The ball is the only body. The ball's surface and the wall have the first two numbers.
    CHECK(process.tracks() == std::set<int>{1, 2});
    CHECK(process.body_tracks() == std::set<int>{3});
  }
}

TEST_CASE("clouds before the first pose are not tracked, and the log's end says so",
          "[process][track][pose]") {
  Process process(settings_with_poses());
  process.take("POINT_CLOUD", encode_view(100000, camera_at(0)), 100000);
  process.pass(200000);
  CHECK(process.tracks() == std::set<int>{0});
  process.take("CAMERA", encode_pose(200000, camera_at(0)), 200000);
  process.take("POINT_CLOUD", encode_view(200000, camera_at(0)), 200000);
  CHECK(process.tracks() == std::set<int>{1, 2});
  REQUIRE(process.node.find_oddities().size() == 1);
  CHECK(process.node.find_oddities()[0].find("1 of 2 clouds") == 0);
}

TEST_CASE("if no pose ever comes, the log says so once in a while and the status counts the clouds",
          "[process][track][pose]") {
  Process process(settings_with_poses());
  const test::LoggedLines log;
  for (int k = 1; k <= 3; ++k) {
    process.take("POINT_CLOUD", encode_view(100000 * k, camera_at(0)), 100000 * k);
  }
  process.pass(400000);
  const std::size_t first =
      log.text().find("CAMERA: cloud 100000 is not tracked: no pose has come");
  CHECK(first != std::string::npos);
  CHECK(log.text().find("not tracked", first + 40) == std::string::npos);
  CHECK(process.untracked() == "no_pose 3 ");
}

TEST_CASE("a pose that is too old counts as none, and the status tells its age",
          "[process][track][pose]") {
  DetectorSettings settings = settings_with_poses();
  settings.track.pose_age = 0.2;
  Process process(settings);
  CHECK(process.untracked().empty());
  CHECK(process.status.pose_age == -1.0);
  process.take("CAMERA", encode_pose(100000, camera_at(0)));
  process.take("CAMERA", encode_pose(490000, camera_at(0)));
  process.take("POINT_CLOUD", encode_view(300000, camera_at(0)));
  CHECK(process.tracks() == std::set<int>{1, 2});
  CHECK(process.untracked().empty());
  CHECK(process.status.pose_age == Approx(190.0));
  process.take("POINT_CLOUD", encode_view(300001, camera_at(0)));
  process.pass(1000000);
  CHECK(process.tracks() == std::set<int>{0});
  CHECK(process.untracked() == "old_pose 1 ");
  CHECK(process.status.pose_age == Approx(189.999));
}

TEST_CASE("without a channel of poses, or without tracking, no cloud wants a pose",
          "[process][track][pose]") {
  DetectorSettings idle = settings_with_poses();
  idle.track.enabled = false;
  idle.detector.views.remember = 0.0;
  for (const DetectorSettings& settings : {DetectorSettings(), idle}) {
    Process process(settings);
    process.take("POINT_CLOUD", encode_view(100000, camera_at(0)));
    CHECK(process.published.size() == 1);
    CHECK(process.untracked().empty());
  }
}

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

TEST_CASE("a log that is played again gets the same tracks again", "[process][track]") {
  Process process{DetectorSettings{}};
  for (int pass = 0; pass < 2; ++pass) {
    for (const std::int64_t utime : {100000, 200000}) {
      process.take("POINT_CLOUD", encode_view(utime, camera_at(0)));
    }
  }
  REQUIRE(process.published.size() == 4);
  CHECK(process.published[2] == process.published[0]);
  CHECK(process.published[3] == process.published[1]);
}

TEST_CASE("a pose that is garbage is refused and counted", "[process][pose][hostile]") {
  Process process(settings_with_poses());
  process.take("CAMERA", Bytes(50));
  CHECK(process.node.summary().find("poses in: 1, 1 refused (unknown_type 1)") !=
        std::string::npos);
}

TEST_CASE("what the process is to find alone it reports alone, for a planner may listen",
          "[process][report]") {
  const test::TempFolder folder;
  CLI::App app;
  const DetectorCommandLine command_line(app);
  app.parse("--config " + folder.write("c.toml", "only = [\"sphere\"]\n"));
  const DetectorOptions options = command_line.settings().detector;
  CHECK(options.only.empty());
  CHECK(options.report == std::vector{QuadricType::kSphere});
}

TEST_CASE("the detector's process leaves the planner's settings to the planner", "[process]") {
  const test::TempFolder folder;
  CLI::App app;
  const DetectorCommandLine command_line(app);
  app.parse("--threads 2 --config " +
            folder.write("c.toml", "threads = 3\n[track]\ngate = 5\n[planner]\nnonsense = 1\n"));
  const DetectorSettings settings = command_line.settings();
  CHECK(settings.detector.threads == 2);
  CHECK(settings.track.gate == 5.0);
}

TEST_CASE("clouds and poses cannot come on one channel", "[process][pose]") {
  CLI::App app;
  const DetectorCommandLine command_line(app);
  app.parse("--pose-channel POINT_CLOUD");
  CHECK_THROWS_AS(command_line.settings(), CLI::ParseError);
}

}  // namespace
}  // namespace quadrille

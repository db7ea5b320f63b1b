#include "process/detector/node.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "process/detector/command_line.hpp"
#include "process/detector/detector_process.hpp"
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

using test::Bytes;
using test::camera_at;
using test::encode_pose;
using test::encode_view;
using Process = test::DetectorProcess;

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

TEST_CASE("what is refused about the robot is no refused cloud", "[process][robot][hostile]") {
  Process process{DetectorSettings{}};
  process.take("ROBOT", Bytes(20));
  process.take("FORGET", Bytes(3));
  process.node.publish_status({});
  CHECK(process.status.num_rejected == 0);
  int refused = 0;
  for (const count_t& entry : process.status.rejected_knowledge) {
    refused += static_cast<int>(entry.count);
  }
  CHECK(refused == 2);
  const std::vector<std::string> oddities = process.node.find_oddities();
  CHECK(std::any_of(oddities.begin(), oddities.end(), [](const std::string& oddity) {
    return oddity.find("on the robot") != std::string::npos;
  }));

  process.take("POINT_CLOUD", Bytes(3));
  process.node.publish_status({});
  CHECK(process.status.num_rejected == 1);
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

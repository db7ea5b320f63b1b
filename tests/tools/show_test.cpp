#include "log/event_log.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::check_failure;
using test::contains;
using test::Run;
using test::run_quadrille;

namespace {

std::vector<std::byte> ball_message() {
  DetectionResult result;
  Detection ball;
  ball.id = 1;
  ball.type = QuadricType::kSphere;
  Vector10d q;
  q << 1, 1, 1, 0, 0, 0, 0, 0, 0, -0.0025;
  ball.Q_C = Quadric(q).normalized();
  ball.score = 0.9;
  ball.X_CQ = Eigen::Translation3d(0.1, -0.2, 0.7);
  ball.dimensions = {{"radius", 0.05, 0.0002}};
  result.detections = {ball};
  bus::CloudMessage cloud;
  cloud.utime = 1500;
  cloud.cloud.frame = "camera";
  return bus::encode(bus::to_message(cloud, result));
}

std::vector<std::byte> grasps_message(std::int32_t count) {
  grasps_t m{};
  m.utime = 1500;
  m.gripper = "franka";
  m.num_grasps = count;
  m.grasps.resize(static_cast<std::size_t>(count));
  for (grasp_t& grasp : m.grasps) grasp.width = 0.04;
  m.num_rejected = 1;
  m.rejected.resize(1);
  m.rejected[0].name = "width";
  m.rejected[0].count = 9;
  if (count == 0) {
    m.num_targets = 1;
    m.targets.resize(1);
    m.targets[0].target = 4;
    m.targets[0].furthest = "width";
  }
  return bus::encode(m);
}

std::string write_log(const test::TempFolder& folder,
                      const std::vector<std::vector<std::byte>>& messages) {
  const std::string path = folder.path("published.lcm");
  bus::LogWriter log(path);
  for (const auto& message : messages) log.write(1, "ANY", message);
  log.flush();
  return path;
}

}  // namespace

TEST_CASE("what was published into a log is shown, whatever the channel", "[command][show]") {
  const test::TempFolder folder;
  const Run run = run_quadrille("show " + write_log(folder, {ball_message(), grasps_message(7)}));
  INFO(run.out << run.err);
  CHECK(run.code == 0);
  CHECK(run.err.empty());
  CHECK(contains(run.out, "ANY: cloud 1500 us, frame 'camera', quadrics: 1\n   1  sphere "));
  CHECK(contains(run.out, "radius 50.0 mm"));
  CHECK(contains(run.out, "ANY: cloud 1500 us, hand franka, grasps: 7\n"));
  CHECK(test::lines_of(run.out) == 2 + 1 + 5);
  CHECK_FALSE(contains(run.out, "refused"));
  const Run two = run_quadrille("show --max-grasps 2 " + folder.path("published.lcm"));
  CHECK(test::lines_of(two.out) == 2 + 1 + 2);
}

TEST_CASE("bodies and their tracks are shown", "[command][show]") {
  const test::TempFolder folder;
  SceneBody mug;
  mug.id = 8;
  mug.kind = BodyKind::kRevolution;
  mug.parts = {8, 13};
  mug.X_CB = Eigen::Translation3d(0.1, -0.2, 0.7);
  mug.size = {0.08, 0.08, 0.0954};
  mug.seen = {true, true, false};
  mug.standing_on = 1;
  mug.points = 420;
  mug.track = 3;
  mug.wall = BodyWall{0.004, 0.001};
  bus::CloudMessage cloud;
  cloud.utime = 1500;
  cloud.cloud.frame = "camera";
  const Run run =
      run_quadrille("show " + write_log(folder, {bus::encode(bus::to_message(cloud, {mug})),
                                                 bus::encode(bus::tracks_message(cloud, {mug}))}));
  INFO(run.out << run.err);
  CHECK(contains(run.out, "bodies: 1\n   8  revolution "));
  CHECK(contains(run.out, "80.0 x 80.0 x (95.4) mm, on 1, parts 8 13, wall 4.0 ± 1.0 mm\n"));
  CHECK(contains(run.out, "tracks of bodies: 1\n   8  track 3\n"));
}

TEST_CASE("of a target without grasps the main reason is shown", "[command][show]") {
  const test::TempFolder folder;
  const Run run = run_quadrille("show " + write_log(folder, {grasps_message(0)}));
  CHECK(contains(run.out, "grasps: 0\n      no grasp on 4: width\n"));
}

TEST_CASE("a log without quadrics and grasps, or with damaged ones, is told",
          "[command][show][hostile]") {
  const test::TempFolder folder;
  auto damaged = grasps_message(3);
  damaged.resize(damaged.size() - 1);
  const Run run = run_quadrille("show " + write_log(folder, {damaged, std::vector<std::byte>(20)}));
  CHECK(run.code == 0);
  CHECK(run.out.empty());
  CHECK(contains(run.err, "1 message of quadrics, boxes, bodies, grasps or status damaged"));
  CHECK(contains(run.err, "holds no quadrics, boxes, bodies, grasps or status; record"));
  check_failure(run_quadrille("show " + folder.path("none.lcm")), "no such file");
  check_failure(run_quadrille("show " + folder.write("text.lcm", "no log")), "is not an LCM log");
}

TEST_CASE("the status of the processes is shown in a line, with its warnings", "[command][show]") {
  const test::TempFolder folder;
  detector_status_t detector{};
  detector.utime = 2'000'000;
  detector.received = 31;
  detector.received_rate = 9.96;
  detector.published = 27;
  detector.missing = 4;
  detector.superseded = 3;
  detector.rejected = {{"cut_short", 1}, {"too_large", 2}};
  detector.num_rejected = 2;
  detector.untracked = {{"no_pose", 5}};
  detector.num_untracked = 1;
  detector.warnings = {"the receive buffer is small"};
  detector.num_warnings = 1;
  planner_status_t planner{};
  planner.received_clouds = 30;
  planner.received_quadrics = 27;
  planner.published = 26;
  planner.unpaired_quadrics = 1;
  std::vector<std::byte> cut = bus::encode(planner);
  cut.pop_back();
  const Run run = run_quadrille(
      "show " + write_log(folder, {bus::encode(detector), bus::encode(planner), cut}));
  INFO(run.out << run.err);
  CHECK(run.code == 0);
  CHECK(contains(run.out,
                 "ANY: detector at 2000000 us: received 31 (10.0 Hz), published 27, missing 4, "
                 "superseded 3, refused 3, failed 0, without a pose 5\n      the receive buffer is "
                 "small\nANY: planner at 0 us: received 30 clouds (0.0 Hz) and 27 quadrics, "
                 "published 26, missing 0, without their cloud 1, "));
  CHECK(contains(run.err,
                 "1 message of quadrics, boxes, bodies, grasps or status "
                 "damaged"));
  CHECK_FALSE(contains(run.err, "holds no quadrics"));
}

TEST_CASE("show prints the messages of one channel where it is named", "[command][show]") {
  const test::TempFolder folder;
  const std::string path = folder.path("two.lcm");
  bus::LogWriter log(path);
  log.write(1, "LEFT", ball_message());
  log.write(2, "RIGHT", grasps_message(1));
  log.flush();
  const Run right = run_quadrille("show --channel RIGHT " + path);
  CHECK(right.err.empty());
  CHECK(contains(right.out, "RIGHT: cloud 1500 us, hand franka"));
  CHECK_FALSE(contains(right.out, "LEFT"));
  const Run none = run_quadrille("show --channel FRONT " + path);
  CHECK(none.out.empty());
  CHECK(contains(none.err, "on FRONT, but events on LEFT (1), RIGHT (1); name another --channel"));
}

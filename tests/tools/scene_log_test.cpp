#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>
#include <vector>

#include "io/cloud_file.hpp"
#include "io/ply/ply.hpp"
#include "lab/scene/scene_files.hpp"
#include "log/event_log.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/pose_message.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::ordered_json;
using test::run_quadrille;

namespace {

/// The clouds and poses of a log, and the hand's shapes.
struct Recording {
  std::vector<bus::CloudMessage> clouds;
  std::vector<bus::PoseMessage> poses;
  std::vector<robot_t> hands;
};

Recording read(const std::string& path) {
  Recording recording;
  bus::LogReader reader(path);
  while (const auto event = reader.next()) {
    if (event->channel == "CAMERA_POSE") {
      recording.poses.push_back(std::get<bus::PoseMessage>(bus::decode_pose(event->bytes)));
    } else if (event->channel == "ROBOT") {
      recording.hands.push_back(std::get<robot_t>(bus::decode_robot(event->bytes)));
    } else {
      REQUIRE(event->channel == "POINT_CLOUD");
      // The hand is told before the cloud.
      if (!recording.hands.empty()) CHECK(recording.hands.size() == recording.clouds.size() + 1);
      recording.clouds.push_back(std::get<bus::CloudMessage>(bus::decode_cloud(event->bytes)));
    }
  }
  return recording;
}

/// The camera's pose at the time of a cloud, between the poses before and after it.
Eigen::Isometry3d pose_at(const std::vector<bus::PoseMessage>& poses, std::int64_t utime) {
  const auto after = std::find_if(poses.begin(), poses.end(),
                                  [&](const auto& pose) { return pose.utime > utime; });
  REQUIRE(after != poses.begin());
  REQUIRE(after != poses.end());
  const auto before = after - 1;
  const double share = static_cast<double>(utime - before->utime) /
                       static_cast<double>(after->utime - before->utime);
  const Eigen::Quaterniond R0(before->X_WC.linear()), R1(after->X_WC.linear());
  const Eigen::Vector3d p0 = before->X_WC.translation(), p1 = after->X_WC.translation();
  return Eigen::Translation3d(p0 + share * (p1 - p0)) * R0.slerp(share, R1);
}

/// Distances from the curved surfaces of the truth of the points near them [m].
std::vector<double> distances(const PointCloud& cloud, const Eigen::Isometry3d& X_WK,
                              const ordered_json& truth) {
  constexpr double kNear = 0.015;
  std::vector<double> near;
  for (const ordered_json& object : truth.at("objects")) {
    if (object.at("kind") != "quadric") continue;
    const Quadric Q_W = scene::quadric_of(object.at("q"));
    const Eigen::Isometry3d X_SW = scene::pose_of(object.at("pose")).inverse();
    Eigen::AlignedBox3d box_S = scene::box_of(object.at("box"));
    // The table begins at the end of a standing body.
    box_S.min().z() += kNear;
    box_S.max().z() -= kNear;
    for (const Eigen::Vector3f& point : cloud.points) {
      const Eigen::Vector3d p_W = X_WK * point.cast<double>();
      if (!point.allFinite() || !box_S.contains(X_SW * p_W)) continue;
      if (const double d = std::abs(Q_W.distance(p_W)); d < kNear) near.push_back(d);
    }
  }
  std::sort(near.begin(), near.end());
  return near;
}

}  // namespace

TEST_CASE("a moving camera's clouds lie on the truth by its poses", "[command][scene][path]") {
  const test::TempFolder folder;
  const std::string log = folder.path("path.lcm");
  const test::Run run = run_quadrille("scene --family tabletop --seed 3 --path 4 --rate 1 " + log);
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(test::contains(run.out, "4 clouds on POINT_CLOUD, poses on CAMERA_POSE"));
  const ordered_json truth = ordered_json::parse(test::content_of(folder.path("path.truth.json")));
  const Recording recording = read(log);
  REQUIRE(recording.clouds.size() == 4);
  CHECK(recording.poses.size() == 302);
  // W is the camera's frame in the first cloud.
  CHECK(pose_at(recording.poses, recording.clouds[0].utime)
            .isApprox(Eigen::Isometry3d::Identity(), 1e-6));
  for (const bus::CloudMessage& message : recording.clouds) {
    CHECK(message.cloud.organised());
    CHECK(message.cloud.width == 640);
    CHECK(message.cloud.height == 480);
    CHECK(message.cloud.frame == "camera");
    const Eigen::Isometry3d X_WK = pose_at(recording.poses, message.utime);
    const std::vector<double> near = distances(message.cloud, X_WK, truth);
    REQUIRE(near.size() > 3000);
    CHECK(near[near.size() / 2] < 0.001);
    CHECK(near[near.size() * 9 / 10] < 0.003);
    // The poses matter: the last camera stands elsewhere.
    if (&message == &recording.clouds.back()) {
      CHECK(X_WK.translation().norm() > 0.2);
      const auto moved = distances(message.cloud, Eigen::Isometry3d::Identity(), truth);
      CHECK((moved.empty() || moved[moved.size() / 2] > 0.004));
    }
  }
}

TEST_CASE("the same seed gives the same log, whatever the error of its poses the same clouds",
          "[command][scene][path][determinism]") {
  const test::TempFolder folder;
  const std::string a = folder.path("a.lcm"), b = folder.path("b.lcm"), off = folder.path("o.lcm");
  const std::string command = "scene --family tabletop --seed 9 --path 2 ";
  REQUIRE(run_quadrille(command + a).code == 0);
  REQUIRE(run_quadrille(command + b).code == 0);
  REQUIRE(run_quadrille(command + off + " --pose-error 0.005,0.5").code == 0);
  CHECK(test::content_of(a) == test::content_of(b));
  CHECK(test::content_of(scene::truth_path(a)) == test::content_of(scene::truth_path(b)));
  CHECK(test::content_of(scene::truth_path(a)) == test::content_of(scene::truth_path(off)));
  const Recording exact = read(a), wrong = read(off);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(bus::digest_of(exact.clouds[i].cloud) == bus::digest_of(wrong.clouds[i].cloud));
  }
  const double shift =
      (exact.poses[0].X_WC.translation() - wrong.poses[0].X_WC.translation()).norm();
  CHECK(shift > 1e-4);
  CHECK(shift < 0.03);
}

TEST_CASE("the hand that a log shows is told with each cloud, and changes nothing else",
          "[command][scene][path][robot]") {
  const std::string gripper = GENERATE("franka", "robotiq_2f85", "robotiq_2f140", "wsg50");
  CAPTURE(gripper);
  const test::TempFolder folder;
  const std::string plain = folder.path("plain.lcm"), hand = folder.path("hand.lcm");
  const std::string command = "scene --family tabletop --seed 3 --path 2 --rate 1 ";
  REQUIRE(run_quadrille(command + plain).code == 0);
  REQUIRE(run_quadrille(command + hand + " --hand " + gripper).code == 0);
  const Recording without = read(plain), with = read(hand);
  REQUIRE(without.hands.empty());
  REQUIRE(with.hands.size() == 2);
  REQUIRE(with.poses.size() == without.poses.size());
  const auto last_pose = [](const Recording& recording) {
    return recording.poses.back().X_WC.matrix();
  };
  CHECK(last_pose(with) == last_pose(without));
  for (std::size_t i = 0; i < 2; ++i) {
    const robot_t& told = with.hands[i];
    CHECK(told.utime == with.clouds[i].utime);
    CHECK(told.frame == "camera");
    RobotShapes robot;
    robot.padding = told.padding;
    for (const collision_shape_t& shape : told.shapes) {
      robot.shapes.push_back(bus::from_message(shape));
    }
    const auto points_in = [](const PointCloud& cloud) {
      return std::count_if(cloud.points.begin(), cloud.points.end(),
                           [](const Eigen::Vector3f& p) { return p.allFinite(); });
    };
    const PointCloud &seen = with.clouds[i].cloud, &bare = without.clouds[i].cloud;
    const PointCloud rest = robot.taken_from(seen);
    const auto on_hand = points_in(seen) - points_in(rest);
    // Two fingers; nothing else is so near, but for rays that are mixed at their edges, and strays.
    CHECK(on_hand > 0.01 * static_cast<double>(points_in(seen)));
    CHECK(on_hand < 0.2 * static_cast<double>(points_in(seen)));
    CHECK(points_in(robot.taken_from(bare)) == points_in(bare));
    const auto near = std::count_if(rest.points.begin(), rest.points.end(),
                                    [](const Eigen::Vector3f& p) { return p.norm() < 0.25f; });
    CHECK(near < 0.01 * static_cast<double>(on_hand));
  }
}

TEST_CASE("detect and plan leave out the hand that a log tells", "[command][scene][path][robot]") {
  const test::TempFolder folder;
  const std::string log = folder.path("hand.lcm");
  REQUIRE(run_quadrille("scene --family tabletop --seed 4 --path 3 --rate 1 --hand franka " + log)
              .code == 0);
  for (const std::string command : {"detect --json - ", "plan --gripper franka --json - "}) {
    for (const std::string poses : {"", " --pose-channel CAMERA_POSE"}) {
      CAPTURE(command, poses);
      const auto things_near_camera = [&](const std::string& more) {
        const test::Run run = run_quadrille(command + log + poses + more);
        REQUIRE(run.code == 0);
        // The frame of the first cloud is that of the poses, so the hand is there in both.
        const auto json = nlohmann::json::parse(run.out.substr(0, run.out.find('\n')));
        return std::count_if(
            json.at("detections").begin(), json.at("detections").end(), [](const auto& detection) {
              const auto p = detection.at("pose").at("position");
              return std::hypot(p[0].template get<double>(), p[1].template get<double>(),
                                p[2].template get<double>()) < 0.25;
            });
      };
      CHECK(things_near_camera("") == 0);
      CHECK(things_near_camera(" --robot-channel NOBODY") > 0);
    }
  }
}

TEST_CASE("a scene is written as several views, all in the frame of the first",
          "[command][scene][view]") {
  const test::TempFolder folder;
  const std::string one = folder.path("one.ply"), all = folder.path("all.ply");
  const std::string command = "scene --family tabletop --seed 7 ";
  REQUIRE(run_quadrille(command + one).code == 0);
  const test::Run made = run_quadrille(command + "--views 3 " + all);
  REQUIRE(made.code == 0);
  CHECK(test::content_of(one) == test::content_of(all));
  CHECK(test::content_of(scene::truth_path(one)) == test::content_of(scene::truth_path(all)));
  std::string views;
  for (const char* name : {"all.view1.ply", "all.view2.ply"}) {
    const std::string path = folder.path(name);
    CHECK(made.out.find(path + ": --camera-pose=") != std::string::npos);
    views += " --view " + path;
  }
  const auto found = [&](const std::string& inputs) {
    const test::Run run = run_quadrille("detect --json - " + inputs);
    REQUIRE(run.code == 0);
    return nlohmann::json::parse(run.out);
  };
  // The views fit each other: their poses need no correction to speak of, and no warning is given.
  const auto json = found(all + views);
  CHECK(json.at("warnings").empty());
  REQUIRE(json.at("views").size() == 2);
  for (const auto& view : json.at("views")) {
    for (const double shift : view.at("correction").at("position")) CHECK(std::abs(shift) < 0.005);
  }
  // A view that was shifted after its viewpoint was told does not fit.
  PointCloud shifted = io::read_cloud(folder.path("all.view1.ply"));
  for (Eigen::Vector3f& p : shifted.points) p += Eigen::Vector3f(0.15f, 0.1f, 0.0f);
  shifted.viewpoint += Eigen::Vector3d(0.15, 0.1, 0.0);
  const std::string wrong = folder.path("wrong.ply");
  io::write_ply(wrong, shifted);
  const auto misfit = found(all + " --view " + wrong + " --view " + folder.path("all.view2.ply"));
  REQUIRE_FALSE(misfit.at("warnings").empty());
  CHECK(test::contains(misfit.at("warnings")[0].get<std::string>(), "another view looks through"));
  // More of the things is seen from three places than from one.
  const auto seen = [](const auto& result) {
    double sum = 0.0;
    for (const auto& detection : result.at("detections")) {
      if (detection.at("type") != "plane") sum += detection.at("seen").template get<double>();
    }
    return sum;
  };
  CHECK(seen(json) > 1.2 * seen(found(one)));
}

TEST_CASE("wrong options of a log of a scene are refused", "[command][scene][path]") {
  const std::pair<const char*, const char*> cases[] = {
      {"s.ply --path 3", "'s.ply' must end in .lcm"},
      {"s.lcm", "'s.lcm' must end in .ply, or needs --path"},
      {"s.lcm --path 1", "--path: "},
      {"s.lcm --path 1001", "--path: "},
      {"s.lcm --path 2.5", "--path: "},
      {"s.lcm --path 3 --rate 101", "'101' is no number from 1 to 100"},
      {"s.lcm --path 3 --pose-error 0.2,1", "'0.2,1' must be from 0 to 0.1 m"},
      {"s.lcm --path 3 --pose-error 0.01", "--pose-error"},
      {"s.lcm --path 3 --labels", "excludes"},
      {"s.lcm --path 3 --hand claw", "--hand: "},
      {"s.ply --views 1", "--views: "},
      {"s.lcm --path 3 --views 2", "--views excludes --path"},
      {"s.ply --hand franka", "requires --path"},
      {"s.ply --rate 3", "requires --path"},
      {"s.ply --pose-error 0,0", "requires --path"}};
  for (const auto& [arguments, part] : cases) {
    const test::Run run = run_quadrille(std::string("scene ") + arguments);
    INFO(arguments << "\n" << run.err);
    CHECK(run.code == 2);
    CHECK(test::lines_of(run.err) == 1);
    CHECK(test::contains(run.err, part));
  }
  const test::TempFolder folder;
  test::check_failure(run_quadrille("scene --path 2 " + folder.path("no/such/s.lcm")),
                      "cannot be created");
}

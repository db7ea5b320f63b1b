#include <fmt/format.h>

#include <Eigen/Geometry>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "io/cloud_file.hpp"
#include "io/ply/ply.hpp"
#include "support/catch.hpp"
#include "support/scans.hpp"
#include "tools/moved_scan.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::contains;
using test::Run;
using test::run_quadrille;
using test::TempFolder;

namespace {

/// A point so far [m] behind the middle of the plane of a cloud that has the most points.
Eigen::Vector3d below_table(const std::string& scene, double distance) {
  const json found = json::parse(run_quadrille("detect --json - " + scene).out);
  json table;
  int most = 0;
  for (const json& d : found["detections"]) {
    if (d["type"] != "plane" || d["inliers"] < most) continue;
    most = d["inliers"];
    table = d["pose"];
  }
  const json &p = table["position"], &q = table["quaternion"];
  const Eigen::Quaterniond R(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                             q[3].get<double>());
  return Eigen::Vector3d(p[0], p[1], p[2]) - distance * (R * Eigen::Vector3d::UnitZ());
}

}  // namespace

TEST_CASE(
    "a scan in another frame, with the camera's pose, yields the grasps of the camera's frame",
    "[command][frames][real]") {
  const TempFolder folder;
  std::mt19937 random(11);
  std::size_t grasps = 0;
  for (const char* name : {"mug.pcd", "bottle.pcd", "boxes.pcd"}) {
    const std::string scan = (test::scans_folder() / name).string();
    const json in_K = test::plan("--gripper franka " + scan);
    const PointCloud cloud = io::read_cloud(scan);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Isometry3d X_WK = test::random_camera_pose(random);
      const std::string moved = folder.write("moved.ply", test::moved_ply(cloud, X_WK));
      const json in_W =
          test::plan("--gripper franka " + moved + " --camera-pose=" + test::pose_option(X_WK));
      CAPTURE(name, k);
      grasps += test::check_same_grasps(in_K, in_W, X_WK);
      CHECK(in_W["viewpoint"][0] == Approx(X_WK.translation().x()));
    }
  }
  CHECK(grasps > 0);
}

TEST_CASE("a cloud in millimetres yields the results of the same cloud in metres",
          "[command][frames]") {
  const TempFolder folder;
  const std::string scene = folder.path("s.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 3 " + scene).code == 0);
  const PointCloud cloud = io::read_cloud(scene);
  const std::string small =
      folder.write("m.ply", test::moved_ply(cloud, Eigen::Affine3d::Identity()));
  const std::string large =
      folder.write("mm.ply", test::moved_ply(cloud, Eigen::Affine3d(Eigen::Scaling(1e3))));
  const json metres = json::parse(run_quadrille("detect --json - " + small).out);
  const json same = json::parse(run_quadrille("detect --json - --unit mm " + large).out);
  REQUIRE(!metres["detections"].empty());
  CHECK(same["detections"] == metres["detections"]);
  CHECK(same["bodies"] == metres["bodies"]);
  CHECK(contains(run_quadrille("detect " + large).err, "--unit mm"));
  // A cloud in metres that is read as millimetres has the warning too, also if a place of the
  // sensor is given.
  for (const char* place : {"", " --viewpoint 0,0,-0.5", " --camera-pose 0.5,0,1,1,0,0,0"}) {
    CAPTURE(place);
    CHECK(contains(run_quadrille("detect --unit mm " + small + place).err, "(--unit mm)"));
  }
  CHECK(run_quadrille("detect --unit inch " + large).code == 2);
  // A log is in metres, as the readers of others expect.
  const std::string from_metres = folder.path("m.lcm"), from_millimetres = folder.path("mm.lcm");
  REQUIRE(run_quadrille("log " + from_metres + " " + small).code == 0);
  REQUIRE(run_quadrille("log --unit mm " + from_millimetres + " " + large).code == 0);
  CHECK(contains(run_quadrille("log --unit mm " + folder.path("s.lcm") + " " + small).err,
                 "do not read them as millimetres (--unit mm)"));
  const json logged = json::parse(run_quadrille("detect --json - " + from_metres).out);
  REQUIRE(!logged["detections"].empty());
  CHECK(json::parse(run_quadrille("detect --json - " + from_millimetres).out)["detections"] ==
        logged["detections"]);
}

TEST_CASE("detections, shapes and tables are in the cloud's own frame", "[command][frames]") {
  const TempFolder folder;
  const std::string scene = folder.path("s.ply"), moved = folder.path("m.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 3 " + scene).code == 0);
  std::mt19937 random(12);
  const Eigen::Isometry3d X_WK = test::random_camera_pose(random);
  folder.write("m.ply", test::moved_ply(io::read_cloud(scene), X_WK));
  const std::string pose = " --camera-pose=" + test::pose_option(X_WK) + " ";
  const json here = json::parse(run_quadrille("detect --json - " + scene).out);
  const json there = json::parse(run_quadrille("detect --json - " + pose + moved).out);
  REQUIRE(there["detections"].size() == here["detections"].size());
  REQUIRE_FALSE(here["detections"].empty());
  for (std::size_t n = 0; n < here["detections"].size(); ++n) {
    const json &a = here["detections"][n]["pose"]["position"],
               &b = there["detections"][n]["pose"]["position"];
    const Eigen::Vector3d p_K(a[0], a[1], a[2]), p_W(b[0], b[1], b[2]);
    CHECK((X_WK * p_K - p_W).norm() < 1e-9);
    // The quadric passes where the pose says.
    CHECK(there["detections"][n]["dimensions"] == here["detections"][n]["dimensions"]);
  }
  const Run run =
      run_quadrille("plan --gripper franka --map " + folder.path("m.bt") + pose + moved);
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK(test::content_of(folder.path("m.bt")).starts_with("# Octomap OcTree binary file\n"));
}

TEST_CASE("an option tells where the sensor stood, over what the file says", "[command][frames]") {
  const TempFolder folder;
  const std::string scene = folder.path("s.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 3 " + scene).code == 0);
  // The frame of a robot whose base stands below the table.
  const Eigen::Vector3d below = below_table(scene, 0.25);
  PointCloud cloud = io::read_cloud(scene);
  for (Eigen::Vector3f& p : cloud.points) p -= below.cast<float>();
  cloud.viewpoint.setZero();
  const std::string base = folder.path("base.ply");
  io::write_ply(base, cloud);
  const Run blind = run_quadrille("plan --gripper franka --json - " + base);
  CHECK(blind.code == 0);
  CHECK(json::parse(blind.out)["grasps"].empty());
  CHECK(json::parse(blind.out)["rejected"].contains("viewpoint"));
  INFO(blind.err);
  CHECK(test::lines_of(blind.err) == 1);
  CHECK(contains(blind.err, "cannot have been seen from its viewpoint 0.000, 0.000, 0.000: "));
  CHECK(contains(blind.err, "--viewpoint"));
  const json seen = test::plan(fmt::format("--gripper franka --viewpoint={},{},{} {}", -below.x(),
                                           -below.y(), -below.z(), base));
  CHECK_FALSE(seen["grasps"].empty());
  CHECK(seen["viewpoint"][1] == Approx(-below.y()));
}

TEST_CASE("a viewpoint or a pose that is none is wrong usage", "[command][frames]") {
  const TempFolder folder;
  const std::string detect = "detect " + folder.write("a.ply", test::ply_of({"1 2 3"}));
  for (const char* wrong :
       {"--viewpoint 1,2", "--viewpoint 1,2,x", "--viewpoint 1,2,nan", "--viewpoint 1,2,3,",
        "--camera-pose 1,2,3", "--camera-pose 0,0,0,2,0,0,0",
        "--viewpoint 0,0,0 --camera-pose 0,0,0,1,0,0,0"}) {
    const Run run = run_quadrille(detect + " " + wrong);
    CAPTURE(wrong, run.err);
    CHECK(run.code == 2);
    CHECK(test::lines_of(run.err) == 1);
  }
  CHECK(run_quadrille(detect + " --viewpoint=-1,2e-3,0").code == 0);
}

TEST_CASE("types that are not asked for stay in the way of a plan", "[command][report]") {
  const TempFolder folder;
  const std::string scene = folder.path("s.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 7 " + scene).code == 0);
  const std::string planner = "[planner]\nmax_grasps = 100000\n";
  const std::string franka = "--gripper franka --config ";
  const json all = test::plan(franka + folder.write("a.toml", planner) + " " + scene);
  std::map<int, std::string> type_of;
  for (const json& d : all["detections"]) type_of[d["id"].get<int>()] = d["type"];
  const auto grasps_on = [&](const std::string& type) {
    json list = json::array();
    for (json grasp : all["grasps"]) {
      const auto target = type_of.find(grasp["target"].get<int>());
      if (target == type_of.end() || target->second != type) continue;  // boxes have no type
      grasp.erase("target");
      list.push_back(grasp);
    }
    return list;
  };
  const json wanted = grasps_on("sphere");
  REQUIRE_FALSE(wanted.empty());
  REQUIRE(wanted.size() < all["grasps"].size());
  const std::string plain = franka + folder.path("a.toml") + " " + scene;
  for (const std::string& filtered :
       {plain + " --report sphere", plain + " --only sphere",
        franka + folder.write("o.toml", "only = [\"sphere\"]\n" + planner) + " " + scene,
        franka + folder.write("r.toml", "report = [\"sphere\"]\n" + planner) + " " + scene}) {
    json some = test::plan(filtered);
    CAPTURE(filtered);
    for (const json& d : some["detections"]) CHECK(d["type"] == "sphere");
    for (json& grasp : some["grasps"]) grasp.erase("target");
    CHECK(some["grasps"] == wanted);
    CHECK(some["shapes"].size() == all["shapes"].size());
  }
  // The planner may be asked as well; then all is shown.
  json some = test::plan(franka + folder.write("t.toml", planner + "targets = [\"sphere\"]\n") +
                         " " + scene);
  CHECK(some["detections"].size() == all["detections"].size());
  for (json& grasp : some["grasps"]) grasp.erase("target");
  CHECK(some["grasps"] == wanted);
}

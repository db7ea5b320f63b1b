#include <Eigen/Geometry>
#include <algorithm>

#include "support/catch.hpp"
#include "support/scans.hpp"
#include "tools/detections.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;

namespace {

/// Length of a cylinder's annotation: what was seen of its straight part, at least.
bool is_cylinder_as_annotated(const json& detection, const json& object) {
  const json& params = object["params"];
  return test::is_cylinder_of(detection, params["radius"], 0.003) &&
         detection["dimensions"]["length"] > 0.9 * params["length"].get<double>();
}

Eigen::Vector3d vector_of(const json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

/// The middle of a detection's extent, in the frame of the cloud.
Eigen::Vector3d middle_of(const json& detection) {
  const json& q = detection["pose"]["quaternion"];
  const Eigen::Quaterniond rotation(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                                    q[3].get<double>());
  const Eigen::Vector3d low = vector_of(detection["extent"]["min"]);
  const Eigen::Vector3d high = vector_of(detection["extent"]["max"]);
  return rotation * (0.5 * (low + high)) + vector_of(detection["pose"]["position"]);
}

double distance_from_axis(const Eigen::Vector3d& x, const json& cylinder) {
  const Eigen::Vector3d along = vector_of(cylinder["axis_dir"]).normalized();
  return (x - vector_of(cylinder["axis_point"])).cross(along).norm();
}

}  // namespace

TEST_CASE("real scans are read whole and give no number that is not finite", "[command][real]") {
  const json scans = test::manifest_of(test::scans_folder())["scenes"];
  REQUIRE(scans.size() == 3);
  for (const json& scan : scans) test::check_read_whole(test::scans_folder(), scan);
}

TEST_CASE("the annotated objects of real scans are found, with their type", "[command][real]") {
  const json manifest = test::manifest_of(test::scans_folder());
  REQUIRE(manifest["scenes"].size() == 3);
  for (const json& scan : manifest["scenes"]) {
    const std::string file = scan["file"];
    const json detections = test::detect(test::scans_folder() / file)["detections"];
    INFO(file << " " << detections.dump(1));
    for (const json& object : scan["objects"]) {
      CHECK(std::any_of(detections.begin(), detections.end(), [&](const json& d) {
        return object["type"] == "cylinder" ? is_cylinder_as_annotated(d, object)
                                            : d["type"] == object["type"];
      }));
    }
  }
}

TEST_CASE("a mug and a bottle stand on a table, and nothing beside them is curved",
          "[command][real]") {
  const json manifest = test::manifest_of(test::scans_folder());
  for (const json& scan : manifest["scenes"]) {
    const std::string file = scan["file"];
    if (file == "boxes.pcd") continue;
    const json detections = test::detect(test::scans_folder() / file)["detections"];
    INFO(file << " " << detections.dump(1));
    CHECK(std::any_of(detections.begin(), detections.end(),
                      [](const json& d) { return d["type"] == "plane"; }));
    const json& cylinder = scan["objects"][0]["params"];
    int curved = 0;
    for (const json& d : detections) {
      if (d["type"] == "plane") continue;
      ++curved;
      // The inside of the mug, the shoulder and the handle of the bottle are parts of them.
      CHECK(distance_from_axis(middle_of(d), cylinder) < cylinder["radius"].get<double>() + 0.02);
    }
    CHECK(curved <= 3);
  }
}

TEST_CASE("boxes alone give nothing curved", "[command][real]") {
  const json result = test::detect(test::scans_folder() / "boxes.pcd");
  for (const json& d : result["detections"]) {
    INFO(d.dump(1));
    CHECK(d["type"] == "plane");
  }
  CHECK(result["detections"].size() >= 3);
}

TEST_CASE("a real mug is planned a grasp, away from its table", "[command][real]") {
  const std::string scan = (test::scans_folder() / "mug.pcd").string();
  const test::Run run = test::run_quadrille("plan --json - --gripper franka '" + scan + "'");
  INFO(run.err);
  REQUIRE(run.code == 0);
  const json plan = json::parse(run.out);
  REQUIRE_FALSE(plan["grasps"].empty());
  for (const json& grasp : plan["grasps"]) CHECK(grasp["clearance"] >= 0.0);
}

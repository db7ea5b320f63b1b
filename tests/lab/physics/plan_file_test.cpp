#include "lab/physics/plan_file.hpp"

#include <nlohmann/json.hpp>
#include <random>

#include "grasping/scenes.hpp"
#include "io/planner/plan_json.hpp"
#include "io/run_info.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/temp_folder.hpp"

using namespace quadrille;

namespace {

std::string refusal(const std::string& text) {
  const test::TempFolder folder;
  return test::error_of([&] { physics::read_plan(folder.write("p.json", text)); });
}

}  // namespace

TEST_CASE("the grasps of a plan come back from its JSON", "[physics]") {
  std::mt19937 random(2);
  GraspPlan plan;
  for (int i = 0; i < 5; ++i) {
    Grasp grasp;
    grasp.target = i;
    grasp.score = 0.1 * i;
    grasp.width = 0.01 * i;
    grasp.preshape = 0.01 * i + 0.01;
    grasp.contacts_C = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    grasp.X_CG = test::random_pose(random);
    plan.grasps.push_back(grasp);
  }
  io::InputInfo info;
  info.input = "scan.ply";
  DetectionResult result;
  result.detections.emplace_back();
  result.detections[0].id = 7;
  result.detections[0].Q_C = Quadric(Vector10d(3.0 * Vector10d::Unit(2)));
  const test::TempFolder folder;
  const std::string path = folder.write("p.json", io::plan_json(info, {}, result, plan).dump());
  const physics::PlanFile file = physics::read_plan(path);
  REQUIRE(file.detections.size() == 1);
  CHECK(file.detections[0].id == 7);
  CHECK(file.detections[0].Q_C.coefficients()[2] == 3.0);
  CHECK(file.cloud == "scan.ply");
  REQUIRE(file.grasps.size() == plan.grasps.size());
  for (std::size_t i = 0; i < plan.grasps.size(); ++i) {
    CHECK(file.grasps[i].target == plan.grasps[i].target);
    CHECK(file.grasps[i].width == plan.grasps[i].width);
    CHECK(file.grasps[i].preshape == plan.grasps[i].preshape);
    CHECK(file.grasps[i].X_CG.isApprox(plan.grasps[i].X_CG, 1e-12));
  }
}

TEST_CASE("what is no plan is refused", "[physics][hostile]") {
  const std::string grasp =
      R"({"target": 1, "score": 1, "width": 0.1, "preshape": 0.1, "X_CG": {"position": [0, 0, 1], )";
  const auto plan = [&](const std::string& rest) {
    return R"({"input": "a.ply", "detections": [], "grasps": [)" + grasp + rest + "]}";
  };
  CHECK(refusal(plan(R"("quaternion": [1, 0, 0, 0]}})")).empty());
  CHECK(refusal(plan(R"("quaternion": [0, 0, 0, 0]}})")).find("norm") != std::string::npos);
  CHECK(refusal(plan(R"("quaternion": [1, 0, 0]}})")).find("p.json") != std::string::npos);
  CHECK(refusal("{}").find("not what `quadrille plan --json` writes") != std::string::npos);
  CHECK(refusal("").find("p.json") != std::string::npos);
  const std::string fine = plan(R"("quaternion": [1, 0, 0, 0]}})") + "\n";
  CHECK(refusal(fine).empty());
  CHECK(refusal(fine + fine).find("p.json: line 2: holds more than one plan") != std::string::npos);
}

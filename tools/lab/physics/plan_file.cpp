#include "lab/physics/plan_file.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/file_bytes.hpp"

namespace quadrille::physics {
namespace {

using nlohmann::json;

Grasp grasp_of(const json& object) {
  Grasp grasp;
  grasp.target = object.at("target");
  grasp.score = object.at("score");
  grasp.width = object.at("width");
  grasp.preshape = object.at("preshape");
  const auto p = object.at("X_CG").at("position").get<std::array<double, 3>>();
  const auto q = object.at("X_CG").at("quaternion").get<std::array<double, 4>>();
  const Eigen::Quaterniond R(q[0], q[1], q[2], q[3]);
  if (!(std::abs(R.norm() - 1.0) < 1e-3)) throw std::runtime_error("a quaternion is not of norm 1");
  grasp.X_CG.linear() = R.normalized().toRotationMatrix();
  grasp.X_CG.translation() = Eigen::Vector3d(p[0], p[1], p[2]);
  if (!grasp.X_CG.matrix().allFinite() || !(grasp.preshape >= 0.0 && grasp.preshape < 1.0)) {
    throw std::runtime_error("a grasp is not finite");
  }
  return grasp;
}

Detection detection_of(const json& object) {
  const auto q = object.at("q").get<std::array<double, 10>>();
  Detection detection;
  detection.id = object.at("id");
  detection.Q_C = Quadric(Vector10d(q.data()));
  return detection;
}

}  // namespace

PlanFile read_plan(const std::string& path) {
  const std::vector<std::byte> bytes = io::read_file(path);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  try {
    const json object = json::parse(text, text + bytes.size());
    PlanFile plan;
    plan.cloud = object.at("input");
    for (const json& grasp : object.at("grasps")) plan.grasps.push_back(grasp_of(grasp));
    for (const json& detection : object.at("detections")) {
      plan.detections.push_back(detection_of(detection));
    }
    return plan;
  } catch (const std::exception& error) {
    throw io::FileError(path, "",
                        std::string("not what `quadrille plan --json` writes: ") + error.what());
  }
}

}  // namespace quadrille::physics

#include "lab/physics/plan_file.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "io/file_bytes.hpp"
#include "io/json/json_parts.hpp"

namespace quadrille::physics {
namespace {

using json = io::Json;

Grasp grasp_of(const json& object) {
  Grasp grasp;
  grasp.target = object.at("target");
  grasp.score = object.at("score");
  grasp.width = object.at("width");
  grasp.preshape = object.at("preshape");
  grasp.X_CG = io::pose_of(object.at("X_CG"));
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

/// Refuses the output of `quadrille plan` for several inputs, which has one object per line.
void check_single(const std::string& path, std::string_view text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return;
  const bool more = text.find_first_not_of(" \r\n\t", end) != std::string_view::npos;
  if (!more || !json::accept(text.substr(0, end))) return;
  throw io::FileError(path, "line 2", "holds more than one plan; give each a file of its own");
}

}  // namespace

PlanFile read_plan(const std::string& path) {
  const std::vector<std::byte> bytes = io::read_file(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  check_single(path, text);
  try {
    const json object = json::parse(text);
    PlanFile plan;
    plan.cloud = object.at("input");
    for (const json& grasp : object.at("grasps")) plan.grasps.push_back(grasp_of(grasp));
    for (const json& detection : object.at("detections")) {
      plan.detections.push_back(detection_of(detection));
    }
    return plan;
  } catch (const std::exception& error) {
    throw io::json_error(path, "not what `quadrille plan --json` writes", error);
  }
}

}  // namespace quadrille::physics

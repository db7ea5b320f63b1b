#include "quadrille/grasping/grasp_scene.hpp"

#include <utility>

#include "scene/answer_query.hpp"
#include "scene/scene_parts.hpp"

namespace quadrille {
namespace {

Deadline deadline_of(const GraspQuery& query, const PlanOptions& options) {
  return Deadline(query.deadline_ms.value_or(options.deadline_ms));
}

}  // namespace

GraspScene::GraspScene(const PointCloud& cloud, const std::vector<Detection>& detections,
                       const Gripper& gripper, const PlanOptions& options,
                       const std::vector<PointCloud>& further) {
  gripper.check();
  options.check();
  parts_ =
      make_scene_parts(cloud, detections, gripper, options, further, Deadline(options.deadline_ms));
}

GraspScene::GraspScene(GraspScene&&) noexcept = default;
GraspScene& GraspScene::operator=(GraspScene&&) noexcept = default;
GraspScene::~GraspScene() = default;

const std::vector<StageTime>& GraspScene::timings() const { return parts_->timings; }

GraspPlan GraspScene::plan(const GraspQuery& query) const {
  query.check();
  return answer_query(*parts_, query, deadline_of(query, parts_->options));
}

GraspPlan plan_grasps(const PointCloud& cloud, const std::vector<Detection>& detections,
                      const Gripper& gripper, const PlanOptions& options,
                      const std::vector<PointCloud>& further, const GraspQuery& query) {
  gripper.check();
  options.check();
  query.check();
  const Deadline deadline = deadline_of(query, options);
  const std::unique_ptr<const SceneParts> parts =
      make_scene_parts(cloud, detections, gripper, options, further, deadline);
  GraspPlan plan = answer_query(*parts, query, deadline);
  std::vector<StageTime> timings = parts->timings;
  for (const StageTime& stage : timings) plan.total_ms += stage.ms;
  timings.insert(timings.end(), plan.timings.begin(), plan.timings.end());
  plan.timings = std::move(timings);
  return plan;
}

}  // namespace quadrille

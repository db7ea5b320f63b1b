#include "quadrille/grasping/grasp_scene.hpp"

#include <utility>

#include "scene/answer_query.hpp"
#include "scene/scene_parts.hpp"

namespace quadrille {

GraspScene::GraspScene(const PointCloud& cloud, const std::vector<Detection>& detections,
                       const Gripper& gripper, const PlanOptions& options,
                       const std::vector<PointCloud>& further) {
  gripper.check();
  options.check();
  parts_ = make_scene_parts(cloud, detections, gripper, options, further);
}

GraspScene::GraspScene(GraspScene&&) noexcept = default;
GraspScene& GraspScene::operator=(GraspScene&&) noexcept = default;
GraspScene::~GraspScene() = default;

const std::vector<StageTime>& GraspScene::timings() const { return parts_->timings; }

GraspPlan GraspScene::plan(const GraspQuery& query) const {
  query.check();
  return answer_query(*parts_, query);
}

GraspPlan plan_grasps(const PointCloud& cloud, const std::vector<Detection>& detections,
                      const Gripper& gripper, const PlanOptions& options,
                      const std::vector<PointCloud>& further, const GraspQuery& query) {
  const GraspScene scene(cloud, detections, gripper, options, further);
  GraspPlan plan = scene.plan(query);
  std::vector<StageTime> timings = scene.timings();
  for (const StageTime& stage : timings) plan.total_ms += stage.ms;
  timings.insert(timings.end(), plan.timings.begin(), plan.timings.end());
  plan.timings = std::move(timings);
  return plan;
}

}  // namespace quadrille

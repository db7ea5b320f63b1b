#include "quadrille/grasping/grasp_scene.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "scene/answer_query.hpp"
#include "scene/make_scene_parts.hpp"

namespace quadrille {
namespace {

double deadline_of(const GraspQuery& query, const PlanOptions& options) {
  return query.deadline_ms.value_or(options.deadline_ms);
}

}  // namespace

GraspScene::GraspScene(const PointCloud& cloud, const std::vector<Detection>& detections,
                       const Gripper& gripper, const PlanOptions& options,
                       const Surroundings& known, std::optional<std::vector<Box>> boxes,
                       const std::vector<SceneBody>& bodies) {
  gripper.check();
  options.check();
  known.check();
  parts_ = make_scene_parts(cloud, detections, gripper, options, known, std::move(boxes), bodies,
                            options.deadline_ms);
}

GraspScene::GraspScene(GraspScene&&) noexcept = default;
GraspScene& GraspScene::operator=(GraspScene&&) noexcept = default;
GraspScene::~GraspScene() = default;

const std::vector<StageTime>& GraspScene::timings() const { return parts_->timings; }

GraspPlan GraspScene::plan(const GraspQuery& query) const {
  query.check();
  return answer_query(*parts_, query, Deadline(deadline_of(query, parts_->options)));
}

GraspPlan GraspScene::plan_from_start(const GraspQuery& query) const {
  double made_ms = 0.0;
  for (const StageTime& stage : timings()) made_ms += stage.ms;
  GraspQuery rest = query;
  rest.deadline_ms = deadline_of(query, parts_->options);
  if (*rest.deadline_ms > 0.0) {
    // A deadline that passed while the scene was made must not become 0, which is none; the plan
    // then says what it leaves out.
    rest.deadline_ms = std::max(*rest.deadline_ms - made_ms, std::numeric_limits<double>::min());
  }
  GraspPlan plan = this->plan(rest);
  plan.timings.insert(plan.timings.begin(), timings().begin(), timings().end());
  plan.total_ms += made_ms;
  return plan;
}

GraspPlan plan_grasps(const PointCloud& cloud, const std::vector<Detection>& detections,
                      const Gripper& gripper, const PlanOptions& options, const Surroundings& known,
                      const GraspQuery& query, std::optional<std::vector<Box>> boxes,
                      const std::vector<SceneBody>& bodies) {
  PlanOptions timed = options;
  timed.deadline_ms = deadline_of(query, options);
  return GraspScene(cloud, detections, gripper, timed, known, std::move(boxes), bodies)
      .plan_from_start(query);
}

}  // namespace quadrille

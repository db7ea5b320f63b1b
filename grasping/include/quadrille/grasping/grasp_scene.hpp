#pragma once

#include <memory>
#include <string>
#include <vector>

#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

struct SceneParts;

/// One cloud made ready to be asked for grasps: its shapes, its targets and its map of free,
/// occupied and unknown space. Making it takes most of the time of a plan; each query then takes a
/// share of the rest. Queries may run in several threads at once.
class GraspScene {
 public:
  /// As for plan_grasps(); nothing that is given has to outlive this. If the deadline of the
  /// options passes meanwhile, the scene lacks targets, as each plan on it then says.
  QUADRILLE_EXPORT GraspScene(const PointCloud& cloud, const std::vector<Detection>& detections,
                              const Gripper& gripper, const PlanOptions& options = {},
                              const std::vector<PointCloud>& further = {});
  QUADRILLE_EXPORT GraspScene(GraspScene&&) noexcept;
  QUADRILLE_EXPORT GraspScene& operator=(GraspScene&&) noexcept;
  QUADRILLE_EXPORT ~GraspScene();

  /// What it took to make this, by stage.
  QUADRILLE_EXPORT const std::vector<StageTime>& timings() const;

  /// The grasps that are wanted, in the same frame C; its timings and its deadline are those of
  /// this query alone. If nothing can be what is wanted, a warning says why.
  /// @throws std::invalid_argument if the query is out of range
  QUADRILLE_EXPORT GraspPlan plan(const GraspQuery& query = {}) const;

  /// The same as the first query of the scene: what it took to make the scene is among the timings,
  /// and counts for the deadline.
  QUADRILLE_EXPORT GraspPlan plan_from_start(const GraspQuery& query = {}) const;

 private:
  std::unique_ptr<const SceneParts> parts_;
};

}  // namespace quadrille

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

struct SceneParts;

/// One cloud made ready to be asked for grasps: its shapes, its targets and its map of free,
/// occupied and unknown space. Making it takes most of the time of a plan; each query then takes a
/// share of the rest. Queries may run in several threads at once.
class GraspScene {
 public:
  /// As for plan_grasps(); nothing that is given has to outlive this.
  GraspScene(const PointCloud& cloud, const std::vector<Detection>& detections,
             const Gripper& gripper, const PlanOptions& options = {},
             const std::vector<PointCloud>& further = {});
  GraspScene(GraspScene&&) noexcept;
  GraspScene& operator=(GraspScene&&) noexcept;
  ~GraspScene();

  /// What it took to make this, by stage.
  const std::vector<StageTime>& timings() const;

  /// The grasps that are wanted, in the same frame C; its timings are those of this query alone. If
  /// nothing can be what is wanted, a warning says why.
  /// @throws std::invalid_argument if the query is out of range
  GraspPlan plan(const GraspQuery& query = {}) const;

 private:
  std::unique_ptr<const SceneParts> parts_;
};

}  // namespace quadrille

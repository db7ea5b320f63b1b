#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

struct SceneParts;

/// A cloud prepared for grasp queries: its shapes, its targets and its map of free, occupied and
/// unknown space. Preparing the scene takes most of the time of a plan, and each query only a
/// fraction. Several threads may query at once.
class GraspScene {
 public:
  /// The parameters are those of plan_grasps(); none of them has to outlive the scene. If the
  /// deadline in the options passes during construction, some targets are missing, and each plan on
  /// the scene says so.
  QUADRILLE_EXPORT GraspScene(const PointCloud& cloud, const std::vector<Detection>& detections,
                              const Gripper& gripper, const PlanOptions& options = {},
                              const Surroundings& known = {},
                              std::optional<std::vector<Box>> boxes = {},
                              const std::vector<SceneBody>& bodies = {});
  QUADRILLE_EXPORT GraspScene(GraspScene&&) noexcept;
  QUADRILLE_EXPORT GraspScene& operator=(GraspScene&&) noexcept;
  QUADRILLE_EXPORT ~GraspScene();

  /// Returns how long each stage of the construction took.
  QUADRILLE_EXPORT const std::vector<StageTime>& timings() const;

  /// Returns the grasps that the query asks for, in the same frame C. Timings and deadline cover
  /// this query alone. If no target can match the query, a warning says why.
  /// @throws std::invalid_argument if the query is out of range
  QUADRILLE_EXPORT GraspPlan plan(const GraspQuery& query = {}) const;

  /// Like plan(), for the first query on the scene: the construction of the scene is included in
  /// the timings and counts towards the deadline.
  QUADRILLE_EXPORT GraspPlan plan_from_start(const GraspQuery& query = {}) const;

 private:
  std::unique_ptr<const SceneParts> parts_;
};

}  // namespace quadrille

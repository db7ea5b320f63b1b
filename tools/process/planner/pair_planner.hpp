#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "process/planner/knowledge.hpp"
#include "process/planner/pairing.hpp"
#include "process/planner/settings.hpp"
#include "process/runtime/limited_log.hpp"
#include "process/runtime/poses/forgetting.hpp"
#include "quadrille/detector/view_memory.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/grasp_scene.hpp"

namespace quadrille {

/// Plans grasps on clouds with their quadrics, and keeps the last scene ready for further queries.
/// For one thread only, except for cut().
class PairPlanner {
 public:
  using SharedPair = std::shared_ptr<const CloudAndQuadrics>;

  /// The settings must outlive this object.
  explicit PairPlanner(const PlannerSettings& settings)
      : settings_(settings), memory_(settings.detector) {}

  /// Returns the plan in the frame of the results; it has no grasps if the camera's pose is not
  /// known.
  /// @param known  what the robot knows besides
  /// @param query  query in the camera's frame
  /// @param advise  whether to seek remedies for targets without a grasp, and views that would
  /// help;
  ///                see find_remedies() and propose_looks()
  GraspPlan plan(const SharedPair& pair, const Known& known, const GraspQuery& query,
                 bool advise = false);

  /// Remembers what a cloud shows, for plans on later ones, if the camera's pose is known.
  void remember(const CloudAndQuadrics& pair, const Known& known) {
    remember(*pair.cloud, pair.placement, known.surroundings.robot, 0);
  }
  /// The same for any camera.
  /// @param robot   the robot's shapes in the camera's frame
  /// @param camera  0 for the camera on whose clouds grasps are planned
  void remember(const bus::CloudMessage& message, const Placement& placement,
                const RobotShapes& robot, int camera);
  /// Forgets what clouds showed in a region that were taken before this time [us], or all that they
  /// showed if none is named.
  void forget(std::int64_t utime, const std::optional<ForgottenRegion>& region);

  /// Number of plans that the deadline cut short so far. For any thread.
  std::int64_t cut() const { return cut_; }
  /// Number of views that are remembered, and how far the last pose was corrected [m]. For any
  /// thread.
  std::int64_t views() const { return views_; }
  double correction() const { return correction_; }

 private:
  /// @param query  with a deadline
  GraspPlan plan_in_camera(const SharedPair& pair, const Known& known, const GraspQuery& query,
                           bool advise);

  void fit_views(std::size_t views, const GraspPlan& plan);

  const PlannerSettings& settings_;
  /// The last cloud, and its scene in the camera's frame.
  SharedPair ready_;
  std::optional<GraspScene> scene_;
  /// What that scene was made with, without views.
  Surroundings of_scene_;
  /// What earlier clouds showed.
  ViewMemory memory_;
  /// Largest number of views for which there is time.
  std::size_t max_views_ = std::numeric_limits<std::size_t>::max();
  ForgottenTime forgotten_;
  std::atomic<std::int64_t> cut_{0}, views_{0};
  std::atomic<double> correction_{0.0};
  LimitedLog cut_log_;
};

}  // namespace quadrille

// Finds grasps between the outermost points of a target, whatever its shape.
#include <utility>
#include <vector>

#include "contacts/point_holds.hpp"
#include "targets/hand_trials.hpp"

namespace quadrille {
namespace {

// Limits on the effort per target, as for the other kinds of grasps.
constexpr int kMaxChecks = 2000;
constexpr std::size_t kUsualGrasps = 8;
// Normals of points are known to some degrees, like those of fits.
constexpr double kFrictionShare = 0.85;
// Half size of the spot that must be seen to be free beside a thin wall [m].
constexpr double kFreeSpot = 0.001;

}  // namespace

TargetGrasps grasps_by_points(const TargetTask& task, const TargetPoints& points) {
  HandTrials trials(task, kMaxChecks, kUsualGrasps);
  const PlanOptions& options = task.parts.options;
  const ThinWalls walls{options.min_wall, options.max_wall, [&](const Eigen::Vector3d& p_C) {
                          return task.parts.view_of(task.target).sees_past(p_C, kFreeSpot);
                        }};
  for (const Hold& hold :
       point_holds(points.all, points.own, task.parts.gripper, approach_space(task), walls,
                   kFrictionShare * options.friction)) {
    if (trials.done()) break;
    if (const auto why = misfit(hold.line, task)) {
      trials.refuse(*why);
      continue;
    }
    const Eigen::Isometry3d X_CG = grasp_pose(hold.line, hold.approach_C, 0.0);
    trials.try_hand({.line = hold.line,
                     .X_CG = X_CG,
                     .friction = hold.friction,
                     .evidence = hold.evidence,
                     .guessed = hold.guessed});
  }
  return std::move(trials).take();
}

}  // namespace quadrille

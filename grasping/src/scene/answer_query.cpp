#include "scene/answer_query.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "targets/asked_for.hpp"
#include "targets/target_grasps.hpp"
#include "targets/target_scene.hpp"

namespace quadrille {
namespace {

using Clock = std::chrono::steady_clock;

/// Answers one query.
class QueryPlanner {
 public:
  QueryPlanner(const SceneParts& parts, const GraspQuery& query, const Deadline& deadline)
      : parts_(parts), query_(query), deadline_(deadline) {}

  GraspPlan plan() {
    const Clock::time_point start = Clock::now();
    plan_.boxes = parts_.boxes;
    plan_.shapes = parts_.shapes;
    plan_.space = parts_.space;
    plan_.warnings = parts_.warnings;
    const std::vector<const Target*> asked = asked_for(query_, parts_.targets);
    // Refusals of other targets are of no interest to a query that selects some.
    if (!query_.selects()) {
      refusals_ = parts_.refusals;
    } else {
      for (const Target* target : asked) refusals_[Refusal::kUnmeasured] += target->unmeasured;
      // A selected object may be among those for which there was no time.
      refusals_[Refusal::kDeadline] +=
          static_cast<int>(std::count_if(parts_.late.begin(), parts_.late.end(), [&](int id) {
            const std::vector<int>& ids = query_.ids;
            return ids.empty() || std::find(ids.begin(), ids.end(), id) != ids.end();
          }));
      explain(asked);
    }
    for (const Target* target : asked) plan_target(*target);
    warn_of_cut();
    select();
    for (const auto& [why, count] : refusals_) {
      if (count > 0) plan_.rejected.emplace(to_string(why), count);
    }
    const std::chrono::duration<double, std::milli> passed = Clock::now() - start;
    plan_.total_ms = passed.count();
    plan_.timings.push_back({"grasps", plan_.total_ms});
    return std::move(plan_);
  }

 private:
  /// Warns of the parts of the query that no target meets.
  void explain(const std::vector<const Target*>& asked) {
    std::vector<std::string>& warnings = plan_.warnings;
    for (std::string& why : missed_ids(query_, parts_.targets, parts_.why_none)) {
      warnings.push_back(std::move(why));
    }
    const bool explained =
        !query_.ids.empty() && std::all_of(query_.ids.begin(), query_.ids.end(),
                                           [&](int id) { return parts_.why_none.contains(id); });
    if (asked.empty() && !explained) warnings.push_back(why_none(query_, parts_.targets));
  }

  void plan_target(const Target& target) {
    const bool cut = deadline_.passed() || try_holds(target);
    if (cut) ++refusals_[Refusal::kDeadline];
  }

  /// Tries holds by the tips, and then by the points, only if the target is held in no other way.
  /// @return whether the deadline ended the search early
  bool try_holds(const Target& target) {
    const auto task = [&](const CollisionScene& scene) {
      return TargetTask{parts_, query_, deadline_, target, scene};
    };
    bool held = false, cut = false;
    const auto keep = [&](const TargetGrasps& found) {
      plan_.grasps.insert(plan_.grasps.end(), found.grasps.begin(), found.grasps.end());
      for (const auto& [why, number] : found.refusals) refusals_[why] += number;
      held |= !found.grasps.empty();
      cut |= found.cut;
    };
    std::optional<CollisionScene> solid;
    if (target.solid) {
      solid = solid_scene(target, parts_);
      keep(grasps_across(task(*solid)));
    }
    if (target.shell) {
      const CollisionScene shell = shell_scene(target, parts_);
      keep(grasps_at_rim(task(shell)));
    }
    if (solid && !held && !cut) keep(grasps_by_tips(task(*solid)));
    if (!held && !cut) {
      const TargetPoints points = points_about(target, parts_);
      keep(grasps_by_points(task(point_scene(target, points, parts_)), points));
    }
    return cut;
  }

  void warn_of_cut() {
    const int targets = refusals_[Refusal::kDeadline];
    plan_.cut = targets > 0;
    if (!plan_.cut) return;
    plan_.warnings.push_back("the deadline cut the plan; targets not tried, or not to their end: " +
                             std::to_string(targets) +
                             "; raise planner.deadline_ms (--deadline-ms)");
  }

  /// Sorts the grasps, best first, and drops the surplus; each target keeps its best grasp before
  /// any target keeps a second one.
  void select() {
    const auto better = [](const Grasp& a, const Grasp& b) { return a.score > b.score; };
    std::vector<Grasp>& grasps = plan_.grasps;
    std::stable_sort(grasps.begin(), grasps.end(), better);
    const int max_grasps = query_.max_grasps.value_or(parts_.options.max_grasps);
    if (grasps.size() <= static_cast<std::size_t>(max_grasps)) return;
    std::map<int, bool> seen;
    std::stable_partition(grasps.begin(), grasps.end(), [&](const Grasp& grasp) {
      return !std::exchange(seen[grasp.target], true);
    });
    grasps.resize(max_grasps);
    std::stable_sort(grasps.begin(), grasps.end(), better);
  }

  const SceneParts& parts_;
  const GraspQuery& query_;
  const Deadline& deadline_;
  GraspPlan plan_;
  RefusalCounts refusals_;
};

}  // namespace

GraspPlan answer_query(const SceneParts& parts, const GraspQuery& query, const Deadline& deadline) {
  return QueryPlanner(parts, query, deadline).plan();
}

}  // namespace quadrille

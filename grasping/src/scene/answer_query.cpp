#include "scene/answer_query.hpp"

#include <fcl/geometry/collision_geometry.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hand/reachable_places.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "targets/asked_for.hpp"
#include "targets/spread.hpp"
#include "targets/target_grasps.hpp"
#include "targets/target_order.hpp"
#include "targets/target_scene.hpp"
#include "targets/terms.hpp"

namespace quadrille {
namespace {

using Clock = std::chrono::steady_clock;

/// A grasp, and after how many others of its target it is kept if there are too many.
struct Kept {
  Grasp grasp;
  std::size_t rank = 0;
};

/// The box around a shape along the axes of the frame that its pose is in.
Eigen::AlignedBox3d bounds_of(const CollisionShape& shape) {
  const auto& box = shape.geometry->aabb_local;
  return Eigen::AlignedBox3d(box.min_, box.max_).transformed(shape.X_CS);
}

/// The grasps that were found on one target, and the candidates that were refused.
struct Outcome {
  std::vector<Grasp> grasps;
  RefusalCounts refusals;
  /// Number of candidates that were too unlikely to succeed to be tried.
  int unlikely = 0;
};

/// Returns true if a check of what is in the hand's way, or one after it, refused a candidate.
bool was_obstructed(const RefusalCounts& refusals) {
  return refusals.lower_bound(Refusal::kSupport) != refusals.end();
}

/// Answers one query.
class QueryPlanner {
 public:
  QueryPlanner(const SceneParts& parts, const GraspQuery& query, const Deadline& deadline)
      : parts_(parts), query_(completed(query, parts.options)), deadline_(deadline) {
    for (const CollisionShape& shape : query_.attached) attached_G_.push_back(bounds_of(shape));
  }

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
      explain(asked);
    }
    add_refused();
    plan_targets(asked);
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

  /// Adds the outcome for detections and boxes that were refused as targets, unless a body of
  /// unknown shape with the same number is one.
  void add_refused() {
    for (const auto& [id, why] : parts_.refused) {
      if (is_target(id)) continue;
      const std::vector<int>& ids = query_.ids;
      const bool named = std::find(ids.begin(), ids.end(), id) != ids.end();
      if (query_.selects() && !named && !(ids.empty() && why == Refusal::kDeadline)) continue;
      // A selected object may be among those for which there was no time.
      if (query_.selects() && why == Refusal::kDeadline) ++refusals_[why];
      plan_.targets.push_back({id, 0, {{why, 1}}});
    }
  }

  bool is_target(int id) const {
    return std::any_of(parts_.targets.begin(), parts_.targets.end(),
                       [&](const Target& target) { return target.id == id; });
  }

  /// Plans the targets side by side, and adds what was found in their order.
  void plan_targets(const std::vector<const Target*>& asked) {
    if (query_.accept) {
      // The caller's own condition may not be safe for several threads, and may throw.
      for (const Target* target : asked) add(*target, search(*target));
      return;
    }
    const int count = static_cast<int>(asked.size());
    std::vector<Outcome> outcomes(asked.size());
    const std::vector<int> order =
        deadline_.is_set() ? as_given(asked.size()) : costliest_first(asked, parts_);
    parallel_for(count, parts_.options.threads,
                 [&](int k) { outcomes[order[k]] = search(*asked[order[k]]); });
    for (int k = 0; k < count; ++k) add(*asked[k], std::move(outcomes[k]));
  }

  Outcome search(const Target& target) const {
    // No hand that holds the target is farther from it than this.
    const Eigen::AlignedBox3d hands_C = around(target.body, parts_.reach);
    Outcome found;
    if (query_.reach && !may_reach(*query_.reach, Eigen::Isometry3d::Identity(), hands_C)) {
      ++found.refusals[Refusal::kReach];
      return found;
    }
    const bool cut = deadline_.passed() || try_holds(target, found);
    // What stood in the way of likely grasps tells more than that others were unlikely, so that
    // these count only if nothing did.
    if (found.unlikely > 0 && found.grasps.empty() && !was_obstructed(found.refusals)) {
      found.refusals[Refusal::kScore] += found.unlikely;
    }
    if (cut) ++found.refusals[Refusal::kDeadline];
    return found;
  }

  void add(const Target& target, Outcome found) {
    keep(found.grasps, target);
    for (const auto& [why, number] : found.refusals) refusals_[why] += number;
    RefusalCounts refusals = std::move(found.refusals);
    if (target.unmeasured > 0) refusals[Refusal::kUnmeasured] += target.unmeasured;
    // A detection that the hand cannot hold by its shape was refused as a target. Its points were
    // tried all the same, so this refusal belongs to the same outcome.
    if (const auto refused = parts_.refused.find(target.id); refused != parts_.refused.end()) {
      ++refusals[refused->second];
    }
    std::erase_if(refusals, [](const auto& refusal) { return refusal.second == 0; });
    plan_.targets.push_back(
        {target.id, static_cast<int>(found.grasps.size()), std::move(refusals)});
  }

  /// Tries holds by the tips, and then by the points, only if the target is not held in another way
  /// as often as is asked for; once at least.
  /// @param outcome  receives the grasps and the refusals
  /// @return whether the deadline ended the search early
  bool try_holds(const Target& target, Outcome& outcome) const {
    std::vector<Grasp>& grasps = outcome.grasps;
    const auto task = [&](const CollisionScene& scene) {
      return TargetTask{parts_, query_, deadline_, target, scene, {}, attached_G_};
    };
    const std::size_t wanted = std::max(1, *query_.per_target);
    bool cut = false;
    const auto add = [&](const TargetGrasps& found) {
      grasps.insert(grasps.end(), found.grasps.begin(), found.grasps.end());
      for (const auto& [why, number] : found.refusals) outcome.refusals[why] += number;
      outcome.unlikely += found.unlikely;
      cut |= found.cut;
    };
    // A search that continues others must find what they did not.
    const auto further = [&](const CollisionScene& scene) {
      TargetTask next = task(scene);
      next.others = grasps;
      return next;
    };
    std::optional<CollisionScene> solid;
    if (target.solid) {
      solid = with_obstacles(solid_scene(target, parts_), target);
      add(grasps_across(task(*solid)));
    }
    if (target.shell) {
      const CollisionScene shell = with_obstacles(shell_scene(target, parts_), target);
      add(grasps_at_rim(task(shell)));
    }
    if (solid && grasps.size() < wanted && !cut) add(grasps_by_tips(further(*solid)));
    if (grasps.size() < wanted && !cut) {
      if (!near_enough_for_points(target, parts_, *query_.min_score)) {
        ++outcome.unlikely;
        return cut;
      }
      const TargetPoints points = points_about(target, parts_);
      if (all_too_wide(target, points, parts_.gripper)) return cut;
      const CollisionScene scene = with_obstacles(point_scene(target, points, parts_), target);
      add(grasps_by_points(further(scene), points));
    }
    return cut;
  }

  /// Adds the obstacles of the query that a hand at the target may meet.
  CollisionScene with_obstacles(CollisionScene scene, const Target& target) const {
    const Eigen::AlignedBox3d hands_C = around(target.body, parts_.reach + kMaxClearance);
    std::copy_if(query_.obstacles.begin(), query_.obstacles.end(),
                 std::back_inserter(scene.neighbours),
                 [&](const CollisionShape& shape) { return may_reach(shape, hands_C); });
    return scene;
  }

  /// Keeps the grasps of a target, or as many of them as are asked for.
  void keep(const std::vector<Grasp>& grasps, const Target& target) {
    const std::size_t count = *query_.per_target;
    if (count > 0) {
      const double reach = 0.5 * target.body.bounds_Q().sizes().maxCoeff();
      std::size_t rank = 0;
      for (Grasp& pick : spread(grasps, count, reach)) kept_.push_back({std::move(pick), rank++});
      return;
    }
    const auto best = std::max_element(grasps.begin(), grasps.end(), has_less_score);
    for (auto grasp = grasps.begin(); grasp != grasps.end(); ++grasp) {
      kept_.push_back({*grasp, grasp == best ? 0u : 1u});
    }
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
  /// any target keeps a second one. If a number of each target is asked for, each keeps its second
  /// before any keeps a third, and so on.
  void select() {
    const auto better = [](const Kept& a, const Kept& b) { return a.grasp.score > b.grasp.score; };
    const auto earlier = [](const Kept& a, const Kept& b) { return a.rank < b.rank; };
    std::stable_sort(kept_.begin(), kept_.end(), better);
    const std::size_t found = kept_.size(), most = *query_.max_grasps;
    if (found > most) {
      std::stable_sort(kept_.begin(), kept_.end(), earlier);
      kept_.resize(most);
      std::stable_sort(kept_.begin(), kept_.end(), better);
      if (*query_.per_target > 0) {
        plan_.warnings.push_back("of " + std::to_string(found) + " grasps only " +
                                 std::to_string(most) +
                                 " are given; raise planner.max_grasps (--best)");
      }
    }
    for (Kept& kept : kept_) plan_.grasps.push_back(std::move(kept.grasp));
  }

  static bool has_less_score(const Grasp& a, const Grasp& b) { return a.score < b.score; }

  const SceneParts& parts_;
  const GraspQuery query_;
  const Deadline& deadline_;
  /// Boxes around what is fixed to the hand, in its frame G [m].
  std::vector<Eigen::AlignedBox3d> attached_G_;
  std::vector<Kept> kept_;
  GraspPlan plan_;
  RefusalCounts refusals_;
};

}  // namespace

GraspPlan answer_query(const SceneParts& parts, const GraspQuery& query, const Deadline& deadline) {
  return QueryPlanner(parts, query, deadline).plan();
}

}  // namespace quadrille

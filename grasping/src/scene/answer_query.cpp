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
#include "scene/kept_grasps.hpp"
#include "scene/outcome.hpp"
#include "targets/asked_for.hpp"
#include "targets/target_grasps.hpp"
#include "targets/target_name.hpp"
#include "targets/target_order.hpp"
#include "targets/target_scene.hpp"
#include "targets/terms.hpp"

namespace quadrille {
namespace {

using Clock = std::chrono::steady_clock;

/// The box around a shape along the axes of the frame that its pose is in.
Eigen::AlignedBox3d bounds_of(const CollisionShape& shape) {
  const auto& box = shape.geometry->aabb_local;
  return Eigen::AlignedBox3d(box.min_, box.max_).transformed(shape.X_CS);
}

/// Answers one query.
class QueryPlanner {
 public:
  QueryPlanner(const SceneParts& parts, const GraspQuery& query, const Deadline& deadline)
      : parts_(parts),
        query_(completed(query, parts.options)),
        deadline_(deadline),
        kept_(*query_.per_target) {
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
    plan_.grasps = std::move(kept_).best(*query_.max_grasps, &plan_.warnings);
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

  bool is_named(int id) const {
    return std::find(query_.ids.begin(), query_.ids.end(), id) != query_.ids.end();
  }

  /// The id under which the plan tells of a detection or box that was refused as a target.
  int name_of_refused(int id) const {
    const auto body = parts_.body_of.find(id);
    return is_named(id) || body == parts_.body_of.end() ? id : body->second;
  }

  /// Adds the outcomes for detections and boxes that were refused as targets, one for each body,
  /// unless the body or another part of it is a target.
  void add_refused() {
    for (const auto& [id, why] : parts_.refused) {
      const int name = name_of_refused(id);
      if (is_target(name)) continue;
      const bool cut = query_.ids.empty() && why == Refusal::kDeadline;
      if (query_.selects() && !is_named(name) && !cut) continue;
      // A selected object may be among those for which there was no time.
      if (query_.selects() && why == Refusal::kDeadline) ++refusals_[why];
      const auto same = std::find_if(plan_.targets.begin(), plan_.targets.end(),
                                     [&](const TargetOutcome& o) { return o.target == name; });
      TargetOutcome& outcome = same == plan_.targets.end()
                                   ? plan_.targets.emplace_back(TargetOutcome{name, 0, {}})
                                   : *same;
      ++outcome.refusals[why];
    }
  }

  bool is_target(int id) const {
    return std::any_of(parts_.targets.begin(), parts_.targets.end(),
                       [&](const Target& target) { return name_of(target, query_).id == id; });
  }

  /// Plans the targets side by side, and adds what was found on each body in the order of the
  /// bodies' first parts.
  void plan_targets(const std::vector<const Target*>& asked) {
    const int count = static_cast<int>(asked.size());
    std::vector<Outcome> outcomes(asked.size());
    const std::vector<int> order =
        deadline_.is_set() ? as_given(asked.size()) : costliest_first(asked, parts_);
    if (query_.accept) {
      // The caller's own condition may not be safe for several threads, and may throw.
      for (int k = 0; k < count; ++k) outcomes[k] = search(*asked[k]);
    } else {
      parallel_for(count, parts_.options.threads,
                   [&](int k) { outcomes[order[k]] = search(*asked[order[k]]); });
    }
    std::vector<char> added(asked.size(), 0);
    for (int first = 0; first < count; ++first) {
      if (added[first] != 0) continue;
      const int id = name_of(*asked[first], query_).id;
      std::vector<const Target*> targets;
      std::vector<Outcome> parts;
      for (int k = first; k < count; ++k) {
        if (name_of(*asked[k], query_).id != id) continue;
        added[k] = 1;
        targets.push_back(asked[k]);
        parts.push_back(std::move(outcomes[k]));
      }
      add(id, targets, joined(std::move(parts)));
    }
  }

  Outcome search(const Target& target) const {
    // No hand that holds the target is farther from it than this.
    const Eigen::AlignedBox3d hands_C = around(target.body, parts_.reach);
    Outcome found;
    if (query_.reach && !may_reach(*query_.reach, Eigen::Isometry3d::Identity(), hands_C)) {
      ++found.refusals[Refusal::kReach];
      return found;
    }
    found.cut = deadline_.passed() || try_holds(target, found);
    return found;
  }

  /// Adds what was found on a body.
  /// @param id  under which the plan tells of it
  /// @param targets  the body's parts that were asked for
  void add(int id, const std::vector<const Target*>& targets, const Outcome& found) {
    double reach = 0.0;
    for (const Target* target : targets) {
      reach = std::max(reach, 0.5 * target->body.bounds_Q().sizes().maxCoeff());
    }
    kept_.add(found.grasps, reach);
    RefusalCounts refusals = told_refusals(found);
    for (const auto& [why, number] : refusals) refusals_[why] += number;
    for (const Target* target : targets) refusals[Refusal::kUnmeasured] += target->unmeasured;
    // A detection that the hand cannot hold by its shape was refused as a target. Its points, or
    // other parts of its body, were tried all the same, so this refusal belongs to the same
    // outcome.
    for (const auto& [refused, why] : parts_.refused) {
      if (name_of_refused(refused) == id) ++refusals[why];
    }
    std::erase_if(refusals, [](const auto& refusal) { return refusal.second == 0; });
    plan_.targets.push_back({id, static_cast<int>(found.grasps.size()), std::move(refusals)});
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

  void warn_of_cut() {
    const int targets = refusals_[Refusal::kDeadline];
    plan_.cut = targets > 0;
    if (!plan_.cut) return;
    plan_.warnings.push_back("the deadline cut the plan; targets not tried, or not to their end: " +
                             std::to_string(targets) +
                             "; raise planner.deadline_ms (--deadline-ms)");
  }

  const SceneParts& parts_;
  const GraspQuery query_;
  const Deadline& deadline_;
  /// Boxes around what is fixed to the hand, in its frame G [m].
  std::vector<Eigen::AlignedBox3d> attached_G_;
  KeptGrasps kept_;
  GraspPlan plan_;
  RefusalCounts refusals_;
};

}  // namespace

GraspPlan answer_query(const SceneParts& parts, const GraspQuery& query, const Deadline& deadline) {
  return QueryPlanner(parts, query, deadline).plan();
}

}  // namespace quadrille

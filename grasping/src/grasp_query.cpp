#include "quadrille/grasping/grasp_query.hpp"

#include <sstream>
#include <stdexcept>
#include <utility>

#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille {
namespace {

// A direction may miss unit length by rounding to a few digits.
constexpr double kUnitNorm = 1e-6;

template <class Value>
[[noreturn]] void refuse(const char* field, const Value& value, const char* rule) {
  std::ostringstream message;
  message << field << " = " << value << ": must be " << rule;
  throw std::invalid_argument(message.str());
}

void check_approach(const Cone& cone) {
  if (!(std::abs(cone.axis_C.norm() - 1.0) < kUnitNorm)) {
    refuse("approach", cone.axis_C.transpose(), "a unit direction");
  }
  if (!(cone.half_angle > 0.0 && cone.half_angle <= std::numbers::pi)) {
    refuse("approach's angle", cone.half_angle, "more than 0 and at most pi");
  }
}

void check_reach(const Reach& reach) {
  if (!reach.base_C.allFinite()) refuse("reach's base", reach.base_C.transpose(), "finite");
  if (!(reach.min >= 0.0)) refuse("reach's least distance", reach.min, "0 or more");
  if (!(reach.max > 0.0 && reach.max >= reach.min)) {
    refuse("reach's greatest distance", reach.max, "more than 0, and no less than the least one");
  }
}

void check_shapes(const char* field, const std::vector<CollisionShape>& shapes) {
  for (const CollisionShape& shape : shapes) {
    if (!shape.geometry || !shape.X_CS.matrix().allFinite()) {
      refuse(field, shape.kind, "shapes at a pose, made by with_geometry()");
    }
  }
}

}  // namespace

bool GraspQuery::selects() const {
  return !ids.empty() || !tracks.empty() || !types.empty() || region || near_C || min_size > 0.0 ||
         std::isfinite(max_size);
}

void GraspQuery::check() const {
  // The conditions are written so that NaN fails.
  if (!(min_size >= 0.0)) refuse("min_size", min_size, "0 or more");
  if (!(max_size >= min_size)) refuse("max_size", max_size, "min_size or more");
  if (!(min_clearance >= 0.0 && min_clearance <= kMaxMinClearance)) {
    refuse("min_clearance", min_clearance, "0 to 0.03 m, as far as clearances are measured");
  }
  if (near_C && !near_C->allFinite()) refuse("near", near_C->transpose(), "finite");
  if (region && !(region->X_CR.matrix().allFinite() && region->box_R.min().allFinite() &&
                  region->box_R.max().allFinite() && !region->box_R.isEmpty())) {
    refuse("region", "a box", "finite in position and size, its least corner first");
  }
  check_shapes("obstacles", obstacles);
  check_shapes("attached", attached);
  if (approach) check_approach(*approach);
  if (reach) check_reach(*reach);
  if (min_score && !(*min_score >= 0.0 && *min_score <= 1.0)) {
    refuse("min_score", *min_score, "0 to 1");
  }
  if (per_target && *per_target < 0) refuse("per_target", *per_target, "0 or more");
  if (max_grasps && *max_grasps < 1) refuse("max_grasps", *max_grasps, "1 or more");
  if (deadline_ms && !(*deadline_ms >= 0.0 && *deadline_ms <= PlanOptions::kMaxDeadline)) {
    refuse("deadline_ms", *deadline_ms, "0 to 3600000 ms");
  }
}

GraspQuery moved(GraspQuery query, const Eigen::Isometry3d& X_FC) {
  if (query.region) query.region->X_CR = X_FC * query.region->X_CR;
  if (query.near_C) query.near_C = X_FC * *query.near_C;
  if (query.approach) query.approach->axis_C = X_FC.linear() * query.approach->axis_C;
  if (query.reach) query.reach->base_C = X_FC * query.reach->base_C;
  for (CollisionShape& shape : query.obstacles) shape = moved(std::move(shape), X_FC);
  if (query.accept) {
    query.accept = [accept = std::move(query.accept), X_CF = X_FC.inverse()](const Grasp& grasp) {
      return accept(moved(grasp, X_CF));
    };
  }
  return query;
}

GraspQuery completed(GraspQuery query, const PlanOptions& options) {
  options.check();
  const ReachOptions& reach = options.reach;
  if (!query.reach && reach.max > 0.0) {
    query.reach = Reach{Eigen::Vector3d(reach.base.data()), reach.min, reach.max};
  }
  query.min_score = query.min_score.value_or(options.min_score);
  query.per_target = query.per_target.value_or(options.per_target);
  query.max_grasps = query.max_grasps.value_or(options.max_grasps);
  query.deadline_ms = query.deadline_ms.value_or(options.deadline_ms);
  return query;
}

}  // namespace quadrille

#include "quadrille/grasping/grasp_query.hpp"

#include <sstream>
#include <stdexcept>

#include "quadrille/grasping/plan_options.hpp"

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
  if (approach) {
    const double angle = approach->half_angle;
    if (!(std::abs(approach->axis_C.norm() - 1.0) < kUnitNorm)) {
      refuse("approach", approach->axis_C.transpose(), "a unit direction");
    }
    if (!(angle > 0.0 && angle <= std::numbers::pi)) {
      refuse("approach's angle", angle, "more than 0 and at most pi");
    }
  }
  if (max_grasps && *max_grasps < 1) refuse("max_grasps", *max_grasps, "1 or more");
  if (deadline_ms && !(*deadline_ms >= 0.0 && *deadline_ms <= PlanOptions::kMaxDeadline)) {
    refuse("deadline_ms", *deadline_ms, "0 to 3600000 ms");
  }
}

GraspQuery moved(GraspQuery query, const Eigen::Isometry3d& X_FC) {
  if (query.region) query.region->X_CR = X_FC * query.region->X_CR;
  if (query.near_C) query.near_C = X_FC * *query.near_C;
  if (query.approach) query.approach->axis_C = X_FC.linear() * query.approach->axis_C;
  return query;
}

}  // namespace quadrille

#include "quadrille/grasping/plan_options.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

namespace quadrille {
namespace {

constexpr std::size_t kAxes = 3;

/// @throws std::invalid_argument if one option exceeds another one
void check_order(const char* less, double low, const char* more, double high) {
  if (low <= high) return;
  std::ostringstream message;
  message << less << " = " << low << ": must not exceed " << more << " = " << high;
  throw std::invalid_argument(message.str());
}

}  // namespace

void PlanOptions::check() const {
  check_ranges(*this);
  check_order("planner.min_wall", min_wall, "planner.max_wall", max_wall);
  if (reach.base.size() != kAxes) {
    throw std::invalid_argument("planner.reach.base has " + std::to_string(reach.base.size()) +
                                " numbers: must have 3, x, y and z");
  }
  if (reach.max > 0.0) check_order("planner.reach.min", reach.min, "planner.reach.max", reach.max);
}

}  // namespace quadrille

#include "quadrille/grasping/plan_options.hpp"

#include <sstream>
#include <stdexcept>

namespace quadrille {

void PlanOptions::check() const {
  check_ranges(*this);
  if (min_wall <= max_wall) return;
  std::ostringstream message;
  message << "planner.min_wall = " << min_wall
          << ": must not exceed planner.max_wall = " << max_wall;
  throw std::invalid_argument(message.str());
}

}  // namespace quadrille

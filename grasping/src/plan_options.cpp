#include "quadrille/grasping/plan_options.hpp"

#include <stdexcept>
#include <string>

namespace quadrille {

namespace {

void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("plan options: ") + what);
}

}  // namespace

void PlanOptions::check() const {
  demand(resolution >= 0.0005 && resolution <= 0.1, "resolution must lie in 0.0005 to 0.1 m");
  demand(friction > 0.0 && friction <= 10.0, "friction must lie in 0 to 10, above 0");
  demand(approach >= 0.0 && approach <= 1.0, "approach must lie in 0 to 1 m");
  demand(pad_margin >= 0.0 && pad_margin <= 0.1, "pad_margin must lie in 0 to 0.1 m");
  demand(baseline >= 0.0 && baseline <= 1.0, "baseline must lie in 0 to 1 m");
  demand(min_wall >= 0.0 && min_wall <= max_wall && max_wall <= 0.05,
         "min_wall and max_wall must lie in 0 to 0.05 m, in this order");
  demand(max_grasps >= 1, "max_grasps must be at least 1");
}

}  // namespace quadrille

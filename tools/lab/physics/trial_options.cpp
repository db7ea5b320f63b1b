#include <cmath>
#include <stdexcept>

#include "lab/physics/trial.hpp"

namespace quadrille::physics {
namespace {

void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("trial options: ") + what);
}

}  // namespace

void TrialOptions::check() const {
  demand(friction >= 0.0 && friction <= 10.0, "friction must lie in 0 to 10");
  demand(density >= 1.0 && density <= 30000.0, "density must lie in 1 to 30000 kg/m³");
  demand(force >= 0.0 && force <= 10000.0, "force must lie in 0 to 10000 N");
}

}  // namespace quadrille::physics

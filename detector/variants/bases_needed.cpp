#include "variants/bases_needed.hpp"

#include <cmath>
#include <limits>

namespace quadrille {

double bases_needed(double w, int k, double confidence) {
  const double good = std::pow(w, k);
  if (good >= 1.0) return 1.0;
  if (!(good > 0.0)) return std::numeric_limits<double>::infinity();
  return std::ceil(std::log1p(-confidence) / std::log1p(-good));
}

}  // namespace quadrille

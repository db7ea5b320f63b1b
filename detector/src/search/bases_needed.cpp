#include "search/bases_needed.hpp"

#include <cmath>
#include <limits>

namespace quadrille {

int basis_size(BasisKind kind) {
  switch (kind) {
    case BasisKind::kSphere:
      return 1;
    case BasisKind::kTwoPoints:
    case BasisKind::kCylinder:
      return 2;
    case BasisKind::kThreePoints:
    case BasisKind::kCone:
      return 3;
    case BasisKind::kFourPoints:
      return 4;
    case BasisKind::kNinePoints:
      return 9;
  }
  return 0;
}

double bases_needed(double w, int k, double confidence) {
  const double good = std::pow(w, k);
  if (good >= 1.0) return 1.0;
  if (!(good > 0.0)) return std::numeric_limits<double>::infinity();
  return std::ceil(std::log1p(-confidence) / std::log1p(-good));
}

}  // namespace quadrille

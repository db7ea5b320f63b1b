#pragma once

#include <vector>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// A quadric with the samples that support it.
struct Candidate {
  Quadric Q;
  Family family = Family::kGeneral;
  /// Indices of the samples on which it was found.
  std::vector<int> region;
  /// Root mean square distance of the region's samples [m].
  double rms = 0.0;
};

}  // namespace quadrille

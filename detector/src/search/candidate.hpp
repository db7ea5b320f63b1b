#pragma once

#include <vector>

#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/quadric_type.hpp"

namespace quadrille {

/// A quadric with the samples that support it.
struct Candidate {
  Quadric Q;
  Family family = Family::kGeneral;
  /// Indices into the samples that it was found on.
  std::vector<int> region;
  /// Root mean square distance of the region [m].
  double rms = 0.0;
};

}  // namespace quadrille

#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// The parameters of a family of quadrics Q = X⁻ᵀ D X⁻¹: the canonical matrix D varies by the
/// shapes, and the pose X by the motions.
struct FamilySpec {
  std::string_view name;
  /// Row and column of the entries of D that may vary, each together with its mirror image.
  std::vector<std::pair<int, int>> shapes;
  /// Generators in the canonical frame: translations x y z are 0 1 2, rotations 3 4 5.
  std::vector<int> motions;
  /// Degrees of freedom of the surface (the scale of Q does not count).
  int dof;
};

const FamilySpec& family_spec(Family family);

}  // namespace quadrille

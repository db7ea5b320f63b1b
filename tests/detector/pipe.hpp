#pragma once

#include "support/surface_grid.hpp"

namespace quadrille::test {

/// A piece of pipe, seen with half a millimetre of noise, for the tests of surfaces.
inline constexpr double kPipeRadius = 0.04;
inline constexpr int kPipeColumns = 25, kPipeRows = 60;

inline SurfaceSamples pipe() {
  return cylinder_grid(kPipeColumns, kPipeRows, kPipeRadius, 0.004, 0.0005, 1);
}

}  // namespace quadrille::test

#pragma once

#include <vector>

#include "planes/planes.hpp"

namespace quadrille {

/// The planes of a scene, those with the most samples first, and for each plane of a view the
/// number of the scene's plane to which it belongs.
struct UnitedPlanes {
  std::vector<PlaneRegion> planes;
  std::vector<int> number;
};

/// Unites planes that were found in several views and are one: most of the smaller lies on the
/// larger, and they touch.
/// @param samples  samples of all views, on which the planes were found
UnitedPlanes unite_planes(const SurfaceSamples& samples, std::vector<PlaneRegion> planes);

}  // namespace quadrille

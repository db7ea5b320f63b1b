#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "track/look_match.hpp"
#include "track/seen_patch.hpp"

namespace quadrille {

/// The type, dimensions and seen part of a surface, by which it is recognised in the next cloud.
struct SurfaceLook {
  QuadricType type = QuadricType::kPlane;
  std::vector<Dimension> dimensions;
  SeenPatch patch;
};

/// @param X_WC  pose of the detection's frame in the fixed frame
SurfaceLook look_of(const Detection& detection, const Eigen::Isometry3d& X_WC);

/// Standard deviation of the place of a surface [m].
double place_std(const SurfaceLook& look);

/// Returns the surface after a translation [m].
SurfaceLook translated(SurfaceLook look, const Eigen::Vector3d& shift_W);

/// Returns what a surface looks like that was seen anew: as it was seen last.
inline SurfaceLook renewed(const SurfaceLook& /*before*/, const SurfaceLook& now) { return now; }

/// Compares the place, shape and dimensions of two surfaces.
LookMatch match_looks(const SurfaceLook& from, const SurfaceLook& to, const Expectation& expected);

}  // namespace quadrille

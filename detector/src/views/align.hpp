#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Finds the small motion that brings a view onto those before it, by Gauss-Newton steps on the
/// distances of its samples from the tangent planes of the nearest samples there.
///
/// A motion turns by ω about the viewpoint and shifts by t, and both are held near zero by their
/// priors, so that directions in which surfaces slide, such as along a bare table, stay as they
/// were.
/// @param view        the view's samples in frame C, as its pose says
/// @param eye         the view's viewpoint in frame C [m]
/// @param before      samples of the earlier views in frame C
/// @param options     how well the poses are known
/// @return the motion X in X p, within frame C; nullopt if the view has too little in common with
///   those before, or would have to move by more than four standard deviations of its pose
std::optional<Eigen::Isometry3d> align(const SurfaceSamples& view, const Eigen::Vector3d& eye,
                                       const SurfaceSamples& before, const ViewOptions& options);

}  // namespace quadrille

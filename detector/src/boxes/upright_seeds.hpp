#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "boxes/box_seeds.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// The seed of a box that stands upright, from where the samples of a thing lie.
///
/// The normals of a small thing average over its edges, and gather nowhere. Where its samples lie
/// still tells: seen along the up direction, those of its two sides that face the sensor make the
/// shape of an L, and the others are its top. The turn about the up direction is the one at which
/// the samples are nearest to the three sides; samples that are far from all sides count alike.
/// (Zhang et al., "Efficient L-Shape Fitting for Vehicle Detection Using Laser Scanners", IV 2017,
/// fit the same shape to cars.)
/// @param piece  samples of the thing
/// @param up_C   unit direction in which it stands
/// @return nullopt if too few samples lie on the sides, or on one alone
std::optional<BoxSeed> upright_seed(const SurfaceSamples& samples, std::span<const int> piece,
                                    const Eigen::Vector3d& up_C);

}  // namespace quadrille

#pragma once

#include <Eigen/Core>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Tells which of successive samples may lie within the reach of an axis and have a normal line
/// that meets it. The test is a little too lenient and fast, since NormalLine decides on the few
/// that pass.
/// @param direction  unit vector
/// @param may  results for the samples from begin to end, one for those that may, otherwise zero
void may_meet_axis(const SurfaceSamples& samples, int begin, int end, const Eigen::Vector3f& point,
                   const Eigen::Vector3f& direction, float reach, int* may);

}  // namespace quadrille

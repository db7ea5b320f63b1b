#pragma once

#include <vector>

#include "surfaces/surface.hpp"

namespace quadrille {

/// Lets each surface of a scene share as much noise among neighbours as the sensor makes them
/// share.
///
/// The correlation of neighbouring residuals is a property of the sensor, but it is measured on
/// each surface. Where white noise is strong, as far away or on a narrow neck, it hides what the
/// sensor moves the whole surface by, and the deviations of the fit come out ten times too small.
/// So the mean over all surfaces, each weighted by its number of samples, is the least that a
/// surface may have. Means that are as small as those of white noise do not count.
void share_correlation(std::vector<Surface>* surfaces);

}  // namespace quadrille

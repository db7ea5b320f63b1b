#pragma once

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille {

/// True if the sensor saw the inside of a round surface, such as the inner wall of a mug; false for
/// types without an inside.
QUADRILLE_EXPORT bool shows_inside(const Detection& detection);

}  // namespace quadrille

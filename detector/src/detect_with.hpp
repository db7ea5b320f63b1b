#pragma once

#include "quadrille/detector/detector.hpp"
#include "surfaces/find_surfaces.hpp"

namespace quadrille {

/// detect() with another way to search a level.
DetectionResult detect_with(const FindCandidates& find, const CloudView& cloud,
                            const DetectorOptions& options);

}  // namespace quadrille

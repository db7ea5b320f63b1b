#pragma once

#include <functional>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/options.hpp"

namespace quadrille {

/// Receives the result before boxes are sought: complete except for boxes and times.
using QuadricsReady = std::function<void(const DetectionResult& found)>;

/// Detects the quadrics of one cloud by the method of Birdal et al., CVPR 2018.
///
/// Equal clouds, options and seeds give equal bits for any thread count.
/// @param ready  called once as soon as the quadrics are known, before boxes are sought; may be
///   empty
/// @throws std::invalid_argument if an option is out of range (the message names the field)
QUADRILLE_EXPORT DetectionResult detect(const CloudView& cloud, const DetectorOptions& options = {},
                                        const QuadricsReady& ready = {});

/// Detects without boxes, for callers that seek boxes later in their own selection of the
/// detections, like the planner.
QUADRILLE_EXPORT DetectionResult detect_quadrics(const CloudView& cloud,
                                                 const DetectorOptions& options = {});

}  // namespace quadrille

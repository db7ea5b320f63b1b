#pragma once

#include <functional>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/options.hpp"

namespace quadrille {

/// True if the options ask for spheres and nothing else, for which detect() takes the paper's
/// type-specific path.
QUADRILLE_EXPORT bool seeks_spheres_alone(const DetectorOptions& options);

/// The options with which that path works: a sphere's hypothesis needs one point and no null space,
/// and its growth and its fit no choice among families.
QUADRILLE_EXPORT DetectorOptions sphere_options(DetectorOptions options);

/// Gets what was found of a cloud before boxes are looked for: all of the result but these and the
/// times.
using QuadricsReady = std::function<void(const DetectionResult& found)>;

/// Detects the quadrics of one cloud by the method of Birdal et al., CVPR 2018.
///
/// The same cloud, options and seed give the same bits, whatever the thread count.
/// @param ready  called once, for those who wait for the quadrics alone; none by default
/// @throws std::invalid_argument if an option is out of range (the message names the field)
QUADRILLE_EXPORT DetectionResult detect(const CloudView& cloud, const DetectorOptions& options = {},
                                        const QuadricsReady& ready = {});

/// The same without boxes: for those who look for them in what they make of the detections, as the
/// planner does.
QUADRILLE_EXPORT DetectionResult detect_quadrics(const CloudView& cloud,
                                                 const DetectorOptions& options = {});

}  // namespace quadrille

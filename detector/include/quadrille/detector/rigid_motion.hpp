#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "quadrille/detector/box.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// A cloud of frame C in frame F: its points and its viewpoint; the name of the frame stays. Where
/// both are one frame it keeps its bits.
QUADRILLE_EXPORT PointCloud moved(PointCloud cloud, const Eigen::Isometry3d& X_FC);

/// A detection of frame C in frame F. Where both are one frame it keeps its bits.
QUADRILLE_EXPORT Detection moved(Detection detection, const Eigen::Isometry3d& X_FC);

/// Detections of frame C in frame F.
QUADRILLE_EXPORT std::vector<Detection> moved(std::vector<Detection> detections,
                                              const Eigen::Isometry3d& X_FC);

/// Boxes of frame C in frame F.
QUADRILLE_EXPORT std::vector<Box> moved(std::vector<Box> boxes, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille

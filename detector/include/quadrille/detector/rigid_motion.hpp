#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "quadrille/detector/box.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Transforms the points and the viewpoint of a cloud from frame C to frame F; the name of the
/// frame stays. If X_FC is the identity, all bits are kept.
QUADRILLE_EXPORT PointCloud moved(PointCloud cloud, const Eigen::Isometry3d& X_FC);

/// Transforms a detection from frame C to frame F. If X_FC is the identity, all bits are kept.
QUADRILLE_EXPORT Detection moved(Detection detection, const Eigen::Isometry3d& X_FC);

/// Transforms detections from frame C to frame F.
QUADRILLE_EXPORT std::vector<Detection> moved(std::vector<Detection> detections,
                                              const Eigen::Isometry3d& X_FC);

/// Transforms boxes from frame C to frame F.
QUADRILLE_EXPORT std::vector<Box> moved(std::vector<Box> boxes, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille

#pragma once

#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// What a scene needs of a cloud that does not depend on what was detected in it.
struct SeenParts {
  RangeCheck range;
  /// The view of the points within range.
  DepthView view;

  SeenParts(const PointCloud& cloud, const PlanOptions& options)
      : range(check_range(cloud)), view(range.kept(cloud), options.baseline, options.resolution) {}
};

}  // namespace quadrille

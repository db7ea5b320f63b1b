#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "samples/sight.hpp"

namespace quadrille {

/// Knowledge about a scene in addition to its samples.
struct SceneContext {
  /// Unit normal of the plane with the most samples, in frame C and towards the viewpoint. It
  /// usually belongs to a table or floor on which things stand, but may belong to a wall.
  std::optional<Eigen::Vector3d> up;
  /// Depths that the sensor saw, in each view.
  std::vector<Sight> sights;
};

}  // namespace quadrille

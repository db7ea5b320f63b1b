#pragma once

#include <Eigen/Core>
#include <optional>

#include "samples/sight.hpp"

namespace quadrille {

/// What is known of a scene beside its samples.
struct SceneContext {
  /// Unit normal of the plane with the most samples, in frame C and towards the viewpoint: that of
  /// a table or a floor, on which things stand and lie, but it may be that of a wall.
  std::optional<Eigen::Vector3d> up;
  /// What the sensor saw.
  Sight sight;
};

}  // namespace quadrille

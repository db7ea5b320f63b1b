#pragma once

#include <Eigen/Core>
#include <optional>

#include "samples/sight.hpp"

namespace quadrille {

/// What is known of a scene beside its samples.
struct SceneContext {
  /// Unit normal of the largest plane, in frame C: things stand and lie on tables and floors.
  std::optional<Eigen::Vector3d> up;
  /// What the sensor saw.
  Sight sight;
};

}  // namespace quadrille

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/view_memory.hpp"
#include "quadrille/inputs.hpp"

namespace quadrille {

/// What the clouds of a scene showed so far, as quadrille-grasp-planner remembers it.
class LastingScene {
 public:
  /// @param lasts  false if each cloud stands alone
  LastingScene(bool lasts, const DetectorOptions& options) {
    if (lasts) memory_.emplace(options);
  }

  /// Remembers a cloud, and returns what those before it showed, in its frame K.
  /// @param robot  shapes in K of the robot, which are no part of the scene
  std::vector<PointCloud> add(const InputCloud& input, const RobotShapes& robot);

 private:
  std::optional<ViewMemory> memory_;
  std::int64_t files_ = 0;
};

}  // namespace quadrille

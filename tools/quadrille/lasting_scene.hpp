#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/view_memory.hpp"
#include "quadrille/inputs.hpp"

namespace quadrille {

/// Remembers what the clouds of a scene showed so far, as quadrille-grasp-planner does.
class LastingScene {
 public:
  /// @param lasts  false if each cloud stands alone
  LastingScene(bool lasts, const DetectorOptions& options) {
    if (lasts) memory_.emplace(options);
  }

  /// Remembers a cloud, and returns what those before it showed, in its frame K.
  /// @param robot  shapes in K of the robot, which are no part of the scene
  /// @param path  path of the input
  std::vector<PointCloud> add(const InputCloud& input, const std::string& path,
                              const RobotShapes& robot);

 private:
  std::optional<ViewMemory> memory_;
  /// Numbers of the cameras: one for each channel of a log, and one for all files.
  std::map<std::pair<std::string, std::string>, int> cameras_;
  /// Time of the last cloud [us].
  std::int64_t utime_ = 0;
};

}  // namespace quadrille

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/lasting_detector.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/view_memory.hpp"
#include "quadrille/inputs.hpp"

namespace quadrille {

/// Remembers what the clouds of a scene showed so far, as quadrille-detector and
/// quadrille-grasp-planner do.
class LastingScene {
 public:
  /// @param lasts  false if each cloud stands alone
  /// @param plans  whether grasps are planned, which need more of the views than detection
  LastingScene(bool lasts, bool plans, const DetectorOptions& options) {
    if (lasts) detector_.emplace(options);
    if (lasts && plans) memory_.emplace(options);
  }

  bool lasts() const { return detector_.has_value(); }

  /// Detects what a cloud and those before it show, if the scene lasts. The result, and the views
  /// for a plan, are in the cloud's frame K.
  /// @param input  the pose of its K is corrected, so that what several clouds show is at one place
  ///               in the frame of the results, however their poses are off
  /// @param path   path of the input
  /// @param robot  shapes in K of the robot, which are no part of the scene
  /// @param views  receives what the clouds before showed
  DetectionResult detect(InputCloud* input, const std::string& path, const RobotShapes& robot,
                         std::vector<PointCloud>* views);

 private:
  std::optional<LastingDetector> detector_;
  std::optional<ViewMemory> memory_;
  /// Numbers of the cameras: one for each channel of a log, and one for all files.
  std::map<std::pair<std::string, std::string>, int> cameras_;
  /// Time of the last cloud [us].
  std::int64_t utime_ = 0;
};

}  // namespace quadrille

#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "io/json/json.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/inputs.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// More views of the scene of the only input.
struct ViewArguments {
  std::vector<std::string> paths;

  /// Adds --view; this object must outlive the app.
  void add_to(CLI::App& command);
  /// Refuses several inputs, or a log of several clouds, if there are views, since these belong to
  /// one scene.
  /// @throws CLI::ValidationError
  void check(const std::vector<std::string>& inputs) const;
};

/// All views of a scene in the working frame K.
struct SceneViews {
  /// The facts about the input, but with the number of points of all views together, and the time
  /// that reading all of them took.
  io::InputInfo info;
  /// The only view, if it is the input's cloud as it came, which is not copied.
  const PointCloud* only = nullptr;
  /// Otherwise the clouds, the first one first.
  std::vector<PointCloud> several;

  std::span<const PointCloud> clouds() const {
    return only ? std::span<const PointCloud>(only, 1) : several;
  }
  /// For each further view, as JSON: its path, and the motion within the frame C of the files by
  /// which its pose was corrected.
  io::Json corrections = io::Json::array();
};

/// Reads the further views of a scene, each with the viewpoint that its file names, and corrects
/// their poses by what the views see.
/// @param input     the first view, in frame K, with the pose of K in the frame C of all files; it
///   must outlive the views
/// @param robot     shapes in K of the robot; points on them are dropped
/// @param unit      length of the unit of all files [m]
/// @param warnings  receives warnings about the views
SceneViews all_views(const ViewArguments& arguments, const InputCloud& input,
                     const RobotShapes& robot, const DetectorOptions& options, double unit,
                     std::vector<std::string>* warnings);

}  // namespace quadrille

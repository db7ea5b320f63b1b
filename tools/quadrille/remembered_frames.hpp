#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "logs/posed_log_reader.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/input_arguments.hpp"
#include "quadrille/lasting_scene.hpp"
#include "quadrille/log_input.hpp"
#include "quadrille/tracking.hpp"

namespace quadrille {

/// A cloud of a log whose camera moves, with what the clouds before it showed.
struct RememberedFrame {
  /// The cloud with its pose in the fixed frame W, which is corrected by what the clouds before
  /// showed, or why the pose is not known. Then the cloud stands alone, in its own frame.
  LogCloud cloud;
  /// The surfaces, boxes and bodies that this cloud and the clouds before it show, with their
  /// tracks, in the cloud's frame K.
  DetectionResult found;
  /// The remembered views of the clouds before this one, in K. A plan takes them as further views.
  std::vector<PointCloud> views;
  /// Positions of the camera in the fixed frame W [m]: one for each cloud, from the oldest to this
  /// one.
  std::vector<Eigen::Vector3f> path;
};

/// Gives access to the clouds of a log in any order, each with what is remembered of those before
/// it, as the processes remember it. Going forward works on each cloud that is passed; going back
/// begins anew.
class RememberedFrames {
 public:
  /// @param inputs  names the channels and how long clouds wait for poses; its `scene` does not
  ///                count
  RememberedFrames(std::string path, const InputArguments& inputs, const DetectorOptions& options);

  /// Returns a cloud by its number, counted from 0; null if there is none. The frame is valid until
  /// the next call.
  /// @throws std::runtime_error as bus::LogReader does
  const RememberedFrame* at(std::size_t number);

 private:
  /// The state after the clouds that were read so far: the log's reader and the remembered scene.
  struct Run {
    Run(const std::string& path, const InputArguments& inputs, const DetectorOptions& options)
        : reader(open_log(path, inputs)),
          scene(true, true, options),
          tracking(inputs.track, false) {}

    logs::PosedLogReader reader;
    LastingScene scene;
    Tracking tracking;
    std::size_t read = 0;
    RememberedFrame last;
  };

  bool read_next();

  std::string path_;
  InputArguments inputs_;
  DetectorOptions options_;
  std::unique_ptr<Run> run_;
};

}  // namespace quadrille

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "poses/cloud_frame.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The frames of clouds and results, and the unit of clouds.
struct CloudFrames {
  CloudFrame clouds = CloudFrame::kCamera;
  /// Frame of the results; if none is given, that of the clouds.
  std::optional<CloudFrame> results;
  /// Length of the unit of the clouds' coordinates [m].
  double unit = 1.0;

  /// True if conditions on the results are given in the fixed frame.
  bool conditions = false;

  CloudFrame of_results() const { return results.value_or(clouds); }
  /// Returns true if the results depend on the camera's pose.
  bool need_pose() const {
    return clouds == CloudFrame::kWorld || of_results() == CloudFrame::kWorld || conditions;
  }

  /// Adds --cloud-frame, --result-frame and --unit; this object must outlive the app.
  void add_to(CLI::App& app);
};

/// Checks that poses come if they are needed, on a channel of their own.
/// @param fixed  true if the pose of a camera at rest is given
/// @param channels  channels of other messages
/// @throws CLI::ValidationError if poses are missing or share a channel
void check_poses(const CloudFrames& frames, bool fixed, const std::string& pose_channel,
                 const std::vector<std::string>& channels);

}  // namespace quadrille

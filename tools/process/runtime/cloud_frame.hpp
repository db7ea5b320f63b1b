#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/detector/setting.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// A frame that clouds or results are in.
enum class CloudFrame {
  kCamera,  ///< K, the camera's: it looks along z from the origin
  kWorld,   ///< W, fixed, in which the camera's poses are
};

constexpr auto words_of(CloudFrame) {
  return std::to_array<Word<CloudFrame>>(
      {{"camera", CloudFrame::kCamera}, {"world", CloudFrame::kWorld}});
}

/// In which frames clouds come and results go.
struct CloudFrames {
  CloudFrame clouds = CloudFrame::kCamera;
  /// None: as the clouds.
  std::optional<CloudFrame> results;

  CloudFrame of_results() const { return results.value_or(clouds); }
  /// True if the camera's pose decides what the results are.
  bool need_pose() const {
    return clouds == CloudFrame::kWorld || of_results() == CloudFrame::kWorld;
  }

  /// Adds --cloud-frame and --result-frame; this must outlive the app.
  void add_to(CLI::App& app);
};

/// Sees to it that poses come where they are needed, on a channel of their own.
/// @param fixed     whether the pose of a camera at rest is given
/// @param channels  those of other messages
/// @throws CLI::ValidationError if they do not
void check_poses(const CloudFrames& frames, bool fixed, const std::string& pose_channel,
                 const std::vector<std::string>& channels);

}  // namespace quadrille

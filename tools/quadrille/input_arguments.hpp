#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/frame_arguments.hpp"
#include "quadrille/detector/tracker.hpp"

namespace quadrille {

/// Description of the inputs in --help.
inline constexpr const char* kInputs =
    "Clouds: .ply, .pcd, .xyz, .npy (also .gz), .npz, - for one on stdin, or LCM logs; "
    "clouds.lcm#2 is the second cloud of a log, from 1 on";

/// The arguments that select clouds of the inputs and give the sensor's position.
struct InputArguments {
  FrameArguments frames;
  /// Channel of the clouds in logs; if empty, all channels.
  std::string channel;
  /// Channel of the camera's poses X_WK in logs; if empty, clouds stay in their own frame.
  std::string pose_channel;
  /// Channel of the robot's own shapes in logs.
  std::string robot_channel = "ROBOT";
  /// Whether all clouds show one scene at rest. Then a numbered cloud of a log is visited after
  /// those before it.
  bool scene = false;
  /// How long poses are valid, and how long clouds wait for them.
  TrackOptions track;

  /// Adds --viewpoint, --camera-pose, --unit, --channel, --pose-channel, --robot-channel and
  /// --scene; this object must outlive the app.
  void add_to(CLI::App& command);
  /// @throws CLI::ValidationError if a channel is named but none of the inputs is a log, or the
  ///   poses of cameras are not as many as the inputs
  void check(const std::vector<std::string>& paths) const;
  /// Returns what holds for one of the inputs, counted from 0.
  InputArguments of_input(std::size_t n) const;
};

}  // namespace quadrille

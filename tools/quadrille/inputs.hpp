#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/frame_arguments.hpp"
#include "io/json/json.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/tracker.hpp"

namespace quadrille {

/// Description of the inputs in --help.
inline constexpr const char* kInputs =
    "Clouds: .ply, .pcd, .xyz, .npy (also .gz), .npz, - for one on stdin, or LCM logs; "
    "clouds.lcm#2 is the "
    "second "
    "cloud of a log, from 1 on";

/// The arguments that select clouds of the inputs and give the sensor's position.
struct InputArguments {
  FrameArguments frames;
  /// Channel of the clouds in logs; if empty, all channels.
  std::string channel;
  /// Channel of the camera's poses X_WK in logs; if empty, clouds stay in their own frame.
  std::string pose_channel;
  /// Whether all clouds show one scene at rest. Then a numbered cloud of a log is visited after
  /// those before it.
  bool scene = false;
  /// How long poses are valid, and how long clouds wait for them.
  TrackOptions track;

  /// Adds --viewpoint, --camera-pose, --unit, --channel, --pose-channel and --scene; this object
  /// must outlive the app.
  void add_to(CLI::App& command);
  /// @throws CLI::ValidationError if a channel is named but none of the inputs is a log, or the
  ///   poses of cameras are not as many as the inputs
  void check(const std::vector<std::string>& paths) const;
  /// Returns what holds for one of the inputs, counted from 0.
  InputArguments of_input(std::size_t n) const;
};

/// One cloud of an input, with its name and the time that it took to read.
struct InputCloud {
  io::InputInfo info;
  /// False for the clouds of a scene before the one that is asked for.
  bool asked = true;
  /// The cloud in frame K, which is the camera's if its pose was given, otherwise the cloud's own.
  PointCloud cloud;
  /// Pose of K in the frame C in which results are given: the cloud's own, or the fixed frame W of
  /// the poses on the channel of poses.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity();
  /// For clouds of a log: the channel, and the time of capture [us].
  std::string channel;
  std::int64_t utime = 0;
  /// Share of the input that has been read, from 0 to 1.
  double share = 1.0;
  /// Warnings about the log, with the last cloud that is taken from it.
  std::vector<std::string> warnings;
};

/// The only cloud of an input, with warnings about the input.
struct SingleCloud {
  InputCloud input;
  std::vector<std::string> warnings;
};

/// Returns true if a path names an LCM log, which may hold many clouds.
bool is_log(const std::string& path);

/// Returns true if the inputs may give more than one cloud.
bool may_be_several(const std::vector<std::string>& paths);

/// Calls `visit` for each cloud of a file or of an LCM log, in order; for only one cloud of a log
/// if the path ends in its number, "clouds.lcm#2", counted from 1 among those of the channel. If
/// there is a channel of poses, clouds whose pose is not known are left out.
/// @return warnings about a log that could be read in part: where it is truncated, which messages
///   were refused, that it holds no cloud, or clouds of several channels
/// @throws std::runtime_error naming the file if it cannot be read, has no cloud with that number,
///   or has clouds of which none has a pose
std::vector<std::string> for_each_cloud(const std::string& path, const InputArguments& arguments,
                                        const std::function<void(InputCloud)>& visit);

/// The outcome of reading several inputs.
struct ReadingResult {
  std::size_t clouds = 0, inputs = 0, failed = 0;

  /// Returns true if the results are worth keeping.
  bool gave_anything() const { return clouds > 0 || failed == 0; }
  /// @throws std::runtime_error if an input could not be read
  void check() const;
};

/// Calls `visit` for each cloud of each input, and prints warnings about the inputs. It also shows
/// the progress, unless results on the same terminal show that. If there are several inputs, those
/// that cannot be read are reported and skipped.
/// @throws io::FileError if the only input cannot be read
/// @throws std::runtime_error in place of any io::FileError that `visit` throws
ReadingResult for_each_input(const std::vector<std::string>& paths, const InputArguments& arguments,
                             const std::function<void(const std::string& path, InputCloud)>& visit);

/// Reads the only cloud of a file or log.
/// @throws std::runtime_error if it cannot be read, or holds no cloud or several
SingleCloud read_single_cloud(const std::string& path, const InputArguments& arguments = {});

}  // namespace quadrille

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/frame_arguments.hpp"
#include "io/json.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// What --help says of the inputs.
inline constexpr const char* kInputs =
    "Clouds: .ply, .pcd, .xyz, .npy (also .gz), .npz, - for one on stdin, or LCM logs; "
    "clouds.lcm#2 is the "
    "second "
    "cloud of a log, from 1 on";

/// Which clouds of the inputs are wanted, and where the sensor stood, as the command line has it.
struct InputArguments {
  FrameArguments frames;
  /// Of the clouds of logs; empty: all.
  std::string channel;

  /// Adds --viewpoint, --camera-pose and --channel; this must outlive the app.
  void add_to(CLI::App& command);
  /// @throws CLI::ValidationError if a channel is named and none of the inputs is a log
  void check(const std::vector<std::string>& paths) const;
};

/// One cloud of an input, with its name and the time it took to read.
struct InputCloud {
  io::InputInfo info;
  /// In frame K, the camera's where its pose was given, else the cloud's own.
  PointCloud cloud;
  /// Pose of that frame in the cloud's own frame C, in which results are given.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity();
  /// For clouds of a log: the channel, and the time of capture [us].
  std::string channel;
  std::int64_t utime = 0;
  /// How much of its input has been read, from 0 to 1.
  double share = 1.0;
  /// For the last cloud that is taken of a log: what is wrong with the log.
  std::vector<std::string> warnings;
};

/// The only cloud of an input, with what is wrong with the input.
struct SingleCloud {
  InputCloud input;
  std::vector<std::string> warnings;
};

/// True if a path names an LCM log, which may hold many clouds.
bool is_log(const std::string& path);

/// True if inputs may give more than one cloud.
bool may_be_several(const std::vector<std::string>& paths);

/// Calls visit for each cloud of a file or of an LCM log, in order; for one cloud of a log if the
/// path ends in its number, "clouds.lcm#2", counted from 1 among those of the channel.
/// @return what is wrong with a log that gave what it could: where it is cut short, which messages
///   were refused, that it holds no cloud, or clouds of several channels
/// @throws std::runtime_error naming the file if it cannot be read or has no cloud of that number
std::vector<std::string> for_each_cloud(const std::string& path, const InputArguments& arguments,
                                        const std::function<void(InputCloud)>& visit);

/// How the reading of several inputs went.
struct ReadingResult {
  std::size_t clouds = 0, inputs = 0, failed = 0;

  /// True if what came of it is worth keeping.
  bool gave_anything() const { return clouds > 0 || failed == 0; }
  /// @throws std::runtime_error if an input could not be read
  void check() const;
};

/// Calls visit for each cloud of each input and prints what is wrong with the inputs, and how far
/// it is where no results on the same terminal show that. What cannot be read of several inputs is
/// told of and passed over.
/// @throws io::FileError if the only input cannot be read
/// @throws std::runtime_error in place of any io::FileError of visit's
ReadingResult for_each_input(const std::vector<std::string>& paths, const InputArguments& arguments,
                             const std::function<void(const std::string& path, InputCloud)>& visit);

/// The only cloud of a file or log.
/// @throws std::runtime_error if it cannot be read or holds no cloud or several
SingleCloud read_single_cloud(const std::string& path, const InputArguments& arguments = {});

}  // namespace quadrille

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/frame_arguments.hpp"
#include "io/json.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

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
};

/// The only cloud of an input, with what is wrong with the input.
struct SingleCloud {
  InputCloud input;
  std::vector<std::string> warnings;
};

/// True if a path names an LCM log, which may hold many clouds.
bool is_log(const std::string& path);

/// Calls visit for each cloud of a file or of an LCM log, in order.
/// @param frames  where the sensor stood
/// @return what is wrong with a log that gave what it could: where it is cut short, which messages
///   were refused, that it holds no cloud
/// @throws std::runtime_error naming the file if it cannot be read
std::vector<std::string> for_each_cloud(const std::string& path, const FrameArguments& frames,
                                        const std::function<void(InputCloud)>& visit);

/// The only cloud of a file or log.
/// @throws std::runtime_error if it cannot be read or holds no cloud or several
SingleCloud read_single_cloud(const std::string& path, const FrameArguments& frames = {});

}  // namespace quadrille

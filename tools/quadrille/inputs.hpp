#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "quadrille/input_arguments.hpp"
#include "quadrille/input_cloud.hpp"

namespace quadrille {

/// The only cloud of an input, with warnings about the input.
struct SingleCloud {
  InputCloud input;
  std::vector<std::string> warnings;
};

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

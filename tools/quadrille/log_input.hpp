#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "logs/posed_log_reader.hpp"
#include "quadrille/input_arguments.hpp"
#include "quadrille/input_cloud.hpp"

namespace quadrille {

/// Returns true if a path names an LCM log, which may hold many clouds.
bool is_log(const std::string& path);

/// A log, or one of its clouds.
struct LogName {
  std::string path;
  /// Number of the cloud, from 1 on; all clouds if there is none.
  std::optional<int> number;
};

/// Parses "a.lcm" or "a.lcm#2"; nullopt if the text names no log.
/// @throws io::FileError if it names a log, but no number of a cloud
std::optional<LogName> log_name_of(const std::string& text);

/// A cloud of a log.
struct LogCloud {
  InputCloud input;
  /// Why the camera's pose, although asked for, is not known; empty if nothing is missing.
  std::string lack;
  /// Why the robot's shapes, although told, are not known; empty if nothing is missing.
  std::string robot_lack;
};

/// Opens a log to read its clouds one after another.
/// @throws std::runtime_error as bus::LogReader does
logs::PosedLogReader open_log(const std::string& path, const InputArguments& arguments);

/// Reads on to the next cloud of a log; nullopt at its end.
/// @param number  number of that cloud, from 1 on, for its name
std::optional<LogCloud> read_logged_cloud(logs::PosedLogReader& reader, const std::string& path,
                                          const InputArguments& arguments, int number);

/// Calls `visit` for the clouds of a log, or for that of the name's number; if they show one scene,
/// before it for those that came before. Defects of a log are known only at its end and are
/// reported with the last cloud.
/// @return warnings about the log
/// @throws io::FileError if it cannot be read, has no cloud with that number, or has clouds none of
///   which has a pose
std::vector<std::string> visit_log(const LogName& log, const InputArguments& arguments,
                                   const std::function<void(InputCloud)>& visit);

}  // namespace quadrille

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// Calls `visit` for the clouds of a log, or for that of the name's number; if they show one scene,
/// before it for those that came before. Defects of a log are known only at its end and are
/// reported with the last cloud.
/// @return warnings about the log
/// @throws io::FileError if it cannot be read, has no cloud with that number, or has clouds none of
///   which has a pose
std::vector<std::string> visit_log(const LogName& log, const InputArguments& arguments,
                                   const std::function<void(InputCloud)>& visit);

}  // namespace quadrille

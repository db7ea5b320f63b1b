#pragma once

#include <functional>
#include <string>

#include "io/json.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// One cloud of an input, with its name and the time it took to read.
struct InputCloud {
  io::InputInfo info;
  PointCloud cloud;
};

/// True if a path names an LCM log, which may hold many clouds.
bool is_log(const std::string& path);

/// Calls visit for each cloud of a file, in order.
/// @throws io::FileError if the file cannot be read
void for_each_cloud(const std::string& path, const std::function<void(const InputCloud&)>& visit);

/// The single cloud of a file.
/// @throws io::FileError if it cannot be read or holds no cloud or several
InputCloud read_one_cloud(const std::string& path);

}  // namespace quadrille

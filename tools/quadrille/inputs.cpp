#include "quadrille/inputs.hpp"

#include <chrono>
#include <optional>

#include "io/cloud_file.hpp"
#include "io/file_bytes.hpp"

namespace quadrille {
namespace {

InputCloud read_cloud_file(const std::string& path) {
  const auto start = std::chrono::steady_clock::now();
  InputCloud input;
  input.cloud = io::read_cloud(path);
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  input.info = {path, input.cloud.frame, input.cloud.read, elapsed.count()};
  return input;
}

}  // namespace

bool is_log(const std::string& path) { return path.ends_with(".lcm"); }

void for_each_cloud(const std::string& path, const std::function<void(const InputCloud&)>& visit) {
  if (is_log(path)) {
    throw io::FileError(path, "", "LCM logs cannot be read here; give a .ply or .pcd file");
  }
  visit(read_cloud_file(path));
}

InputCloud read_one_cloud(const std::string& path) {
  std::optional<InputCloud> found;
  for_each_cloud(path, [&](const InputCloud& input) {
    if (found) throw io::FileError(path, "", "holds more than one cloud; give a single one");
    found = input;
  });
  if (!found) throw io::FileError(path, "", "holds no cloud; record POINT_CLOUD messages");
  return *found;
}

}  // namespace quadrille

#include "process/runtime/stats_file.hpp"

#include <exception>
#include <utility>

#include "process/runtime/exposition.hpp"
#include "process/runtime/logging.hpp"

namespace quadrille {

StatsFile::StatsFile(std::string path) : path_(std::move(path)) {
  if (!path_.empty()) replace_file(path_, "");
}

void StatsFile::write(const std::string& text) noexcept {
  if (path_.empty()) return;
  try {
    replace_file(path_, text);
  } catch (const std::exception& error) {
    if (log_.admit()) log_error(error.what());
  }
}

}  // namespace quadrille

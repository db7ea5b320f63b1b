#include "process/runtime/status/stats_file.hpp"

#include <exception>
#include <utility>

#include "io/new_file.hpp"

namespace quadrille {

StatsFile::StatsFile(std::string path) : path_(std::move(path)) {
  if (path_.empty()) return;
  claim_ = FileClaim::of_target(path_);
  replace("");
}

void StatsFile::replace(const std::string& text) {
  io::NewFile file(path_);
  file.write(text);
  // The new file is claimed before it replaces the old one, so that the name never refers to an
  // unclaimed file.
  FileClaim claim = FileClaim::of_file(file.path());
  file.commit();
  claim_ = std::move(claim);
}

void StatsFile::write(const std::string& text) noexcept {
  if (path_.empty()) return;
  try {
    replace(text);
  } catch (const std::exception& error) {
    log_.error(error.what());
  }
}

}  // namespace quadrille

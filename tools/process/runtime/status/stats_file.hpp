#pragma once

#include <chrono>
#include <string>

#include "process/runtime/file_claim.hpp"
#include "process/runtime/limited_log.hpp"
#include "run/rate_limiter.hpp"

namespace quadrille {

/// A file that always holds one complete status, the last one, of one process alone.
class StatsFile {
 public:
  /// Creates the file, or empties it.
  /// @param path  path of the file; empty for none
  /// @throws io::FileError if it cannot be written, or belongs to another process
  explicit StatsFile(std::string path);

  /// Replaces the status. Failures are logged at a limited rate, and the work goes on without the
  /// file.
  void write(const std::string& text) noexcept;

 private:
  void replace(const std::string& text);

  std::string path_;
  FileClaim claim_;
  LimitedLog log_{std::chrono::minutes(1)};
};

}  // namespace quadrille

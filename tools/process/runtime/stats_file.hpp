#pragma once

#include <chrono>
#include <string>

#include "process/runtime/file_claim.hpp"
#include "quadrille/bus/rate_limiter.hpp"

namespace quadrille {

/// A file that always holds the last status whole, of one process alone.
class StatsFile {
 public:
  /// Empties it, or makes it.
  /// @param path  empty for none
  /// @throws io::FileError if it cannot be written, or is that of another process
  explicit StatsFile(std::string path);

  /// Replaces it. What fails is logged at a bounded rate: the work goes on without it.
  void write(const std::string& text) noexcept;

 private:
  void replace(const std::string& text);

  std::string path_;
  FileClaim claim_;
  bus::RateLimiter log_{std::chrono::minutes(1)};
};

}  // namespace quadrille

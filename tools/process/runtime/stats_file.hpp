#pragma once

#include <chrono>
#include <string>

#include "quadrille/bus/rate_limiter.hpp"

namespace quadrille {

/// A file that always holds the last status whole.
class StatsFile {
 public:
  /// @param path  empty for none
  /// @throws io::FileError if it cannot be written
  explicit StatsFile(std::string path);

  /// Replaces it. What fails is logged at a bounded rate: the work goes on without it.
  void write(const std::string& text) noexcept;

 private:
  std::string path_;
  bus::RateLimiter log_{std::chrono::minutes(1)};
};

}  // namespace quadrille

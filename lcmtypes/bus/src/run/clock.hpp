#pragma once

#include <chrono>
#include <cstdint>

namespace quadrille::bus {

/// The wall clock as in LCM messages [us since 1970].
inline std::int64_t wall_clock_utime() {
  using std::chrono::microseconds;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<microseconds>(now).count();
}

/// Time since a point in time [ms].
inline double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

}  // namespace quadrille::bus

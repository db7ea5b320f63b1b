#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "log/event_log.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::test {

/// The path of a log in a folder of its own that goes with it.
class TemporaryLog {
 public:
  std::string path() const { return folder_.path("x.lcm"); }

 private:
  TempFolder folder_;
};

/// Three events on A, at 1000, 2000 and 3000 us, of ten bytes 1, 2 and 3.
inline void write_three(const std::string& path) {
  bus::LogWriter writer(path);
  for (int i = 1; i <= 3; ++i) {
    writer.write(1000 * i, "A", std::vector<std::byte>(10, std::byte(i)));
  }
  writer.flush();
}

/// Each of these events takes as many bytes.
inline constexpr std::uintmax_t kEventBytes = 28 + 1 + 10;

}  // namespace quadrille::test

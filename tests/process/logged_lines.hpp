#pragma once

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>

namespace quadrille::test {

/// Collects the records that are logged during its lifetime.
class LoggedLines {
 public:
  LoggedLines() {
    spdlog::set_default_logger(std::make_shared<spdlog::logger>(
        "", std::make_shared<spdlog::sinks::ostream_sink_mt>(stream_)));
  }
  ~LoggedLines() { spdlog::set_default_logger(before_); }
  bool have(const std::string& part) const { return text().find(part) != std::string::npos; }
  std::string text() const { return stream_.str(); }
  int count() const {
    const std::string all = text();
    return static_cast<int>(std::count(all.begin(), all.end(), '\n'));
  }

 private:
  std::ostringstream stream_;
  std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
};

}  // namespace quadrille::test

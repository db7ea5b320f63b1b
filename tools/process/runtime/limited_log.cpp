#include "process/runtime/limited_log.hpp"

#include <fmt/format.h>

#include "process/runtime/logging.hpp"

namespace quadrille {

void LimitedLog::log(void (*write)(const std::string&), const std::string& record) {
  const std::lock_guard lock(mutex_);
  const auto held_back = limiter_.admit();
  if (held_back) write(fmt::format("{}; {} more since the last record", record, *held_back));
}

void LimitedLog::warning(const std::string& record) { log(log_warning, record); }
void LimitedLog::error(const std::string& record) { log(log_error, record); }

}  // namespace quadrille

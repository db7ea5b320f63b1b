#include "process/runtime/limited_log.hpp"

#include <fmt/format.h>

#include "process/runtime/logging.hpp"

namespace quadrille {

std::string with_held_back(const std::string& record, std::int64_t held_back) {
  if (held_back == 0) return record;
  return fmt::format("{}; {} more since the last record", record, held_back);
}

void LimitedLog::log(void (*write)(const std::string&), const std::string& record) {
  const std::lock_guard lock(mutex_);
  if (const auto held_back = limiter_.admit()) write(with_held_back(record, *held_back));
}

void LimitedLog::warning(const std::string& record) { log(log_warning, record); }
void LimitedLog::error(const std::string& record) { log(log_error, record); }

}  // namespace quadrille

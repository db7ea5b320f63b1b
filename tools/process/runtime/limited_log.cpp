#include "process/runtime/limited_log.hpp"

#include <fmt/format.h>

#include "process/runtime/logging.hpp"

namespace quadrille {

void LimitedLog::log(void (*write)(const std::string&), const std::string& record,
                     Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  const auto held_back = limiter_.admit(now);
  if (!held_back) return;
  write(*held_back == 0 ? record
                        : fmt::format("{}; {} more since the last record", record, *held_back));
}

void LimitedLog::warning(const std::string& record, Clock::time_point now) {
  log(log_warning, record, now);
}

void LimitedLog::error(const std::string& record, Clock::time_point now) {
  log(log_error, record, now);
}

}  // namespace quadrille

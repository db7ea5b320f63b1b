#include "process/runtime/logging.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include "quadrille/detector/printable.hpp"

namespace quadrille {

void start_logging(const std::string& program, bool verbose) {
  spdlog::set_default_logger(spdlog::stderr_logger_mt(program));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %n %l: %v");
  spdlog::set_level(verbose ? spdlog::level::debug : spdlog::level::info);
}

void log_debug(const std::string& record) { spdlog::debug("{}", printable(record, kMaxLine)); }
void log_info(const std::string& record) { spdlog::info("{}", printable(record, kMaxLine)); }
void log_warning(const std::string& record) { spdlog::warn("{}", printable(record, kMaxLine)); }
void log_error(const std::string& record) { spdlog::error("{}", printable(record, kMaxLine)); }

}  // namespace quadrille

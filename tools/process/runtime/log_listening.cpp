#include "process/runtime/log_listening.hpp"

#include <fmt/format.h>

#include "process/runtime/logging.hpp"

namespace quadrille {

void log_listening(const std::vector<std::string>& channels, const std::string& url,
                   const bus::Connection& connection) {
  const auto buffer = connection.traffic().receive_buffer;
  const std::string granted =
      buffer > 0 ? fmt::format(", with a receive buffer of {} bytes", buffer) : "";
  for (const std::string& channel : channels) {
    log_info(fmt::format("listening to {} on {}{}", channel, url, granted));
  }
}

}  // namespace quadrille

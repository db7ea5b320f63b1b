#include "process/runtime/status/status.hpp"

#include <fmt/format.h>

namespace quadrille {

transport_t to_message(const bus::Traffic& traffic) {
  transport_t message;
  message.largest_message = traffic.largest_message;
  message.receive_buffer = traffic.receive_buffer;
  message.dropped_datagrams = traffic.dropped_datagrams;
  message.filtered_datagrams = traffic.filtered_datagrams;
  message.unclear_datagrams = traffic.unclear_datagrams;
  message.dropped_messages = traffic.dropped_messages;
  return message;
}

std::string list_counts(const std::vector<count_t>& counts) {
  std::string text;
  for (const count_t& entry : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", entry.name, entry.count);
  }
  return text;
}

}  // namespace quadrille

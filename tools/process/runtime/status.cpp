#include "process/runtime/status.hpp"

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

}  // namespace quadrille

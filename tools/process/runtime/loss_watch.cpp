#include "process/runtime/loss_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "quadrille/bus/network.hpp"

namespace quadrille {
namespace {

/// A buffer for the messages that come; one that has overflowed is too small for their bursts.
int buffer_after_loss(const bus::Traffic& traffic) {
  constexpr std::int64_t kMost = 1 << 30;
  const std::int64_t doubled = std::min(2 * traffic.receive_buffer, kMost);
  int wanted = bus::advised_receive_buffer(traffic.largest_message);
  while (wanted < doubled) wanted *= 2;
  return wanted;
}

std::string describe_datagrams(const bus::Traffic& traffic) {
  if (traffic.dropped_datagrams <= 0) return "";
  return fmt::format(
      "{} datagrams, at most as many messages, were lost because the receive buffer of {} bytes "
      "was "
      "full; the largest message has {} bytes; mend it with: {}",
      traffic.dropped_datagrams, traffic.receive_buffer, traffic.largest_message,
      bus::mend_receive_buffer(traffic.asked_buffer, buffer_after_loss(traffic)));
}

std::string describe_messages(const bus::Traffic& traffic) {
  if (traffic.dropped_messages <= 0) return "";
  return fmt::format(
      "{} messages were driven out by newer ones before they were read: this process gets too "
      "little "
      "of the processor; give it more, or send fewer",
      traffic.dropped_messages);
}

}  // namespace

std::optional<std::string> LossWatch::check(const bus::Traffic& traffic, Clock::time_point now) {
  if (traffic.dropped_datagrams <= told_datagrams_ && traffic.dropped_messages <= told_messages_) {
    return std::nullopt;
  }
  if (!log_.admit(now)) return std::nullopt;
  told_datagrams_ = traffic.dropped_datagrams;
  told_messages_ = traffic.dropped_messages;
  return describe(traffic);
}

std::vector<std::string> LossWatch::find_warnings(const bus::Traffic& traffic,
                                                  const std::vector<std::string>& at_start) {
  std::vector<std::string> warnings;
  for (const std::string& loss : {describe_datagrams(traffic), describe_messages(traffic)}) {
    if (!loss.empty()) warnings.push_back(loss);
  }
  if (!warnings.empty()) return warnings;
  if (traffic.largest_message == 0) return at_start;
  if (traffic.receive_buffer == 0) return {};
  if (auto problem = bus::find_buffer_problem(traffic.asked_buffer, traffic.receive_buffer,
                                              traffic.largest_message)) {
    warnings.push_back(std::move(*problem));
  }
  return warnings;
}

std::string LossWatch::describe(const bus::Traffic& traffic) {
  const std::string datagrams = describe_datagrams(traffic), messages = describe_messages(traffic);
  return datagrams + (datagrams.empty() || messages.empty() ? "" : "; ") + messages;
}

}  // namespace quadrille

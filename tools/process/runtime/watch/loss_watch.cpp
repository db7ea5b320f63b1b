#include "process/runtime/watch/loss_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "link/network.hpp"

namespace quadrille {
namespace {

/// Returns a receive buffer for the messages that come. A buffer that has overflowed is too small
/// for their bursts, so it is at least doubled.
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

std::string describe_unclear(const bus::Traffic& traffic) {
  if (traffic.unclear_datagrams <= 0) return "";
  return fmt::format(
      "{} datagrams were lost because the receive buffer of {} bytes was full, or refused by the "
      "filter of this process: the kernel does not tell which",
      traffic.unclear_datagrams, traffic.receive_buffer);
}

std::string describe_filtered(const bus::Traffic& traffic) {
  if (traffic.filtered_datagrams <= 0) return "";
  return fmt::format(
      "{} datagrams were refused by the filter of this process: their senders are not among those "
      "of --accept-from, or they are such as no LCM sends; nothing else is lost by that",
      traffic.filtered_datagrams);
}

/// Returns the texts that are not empty.
std::vector<std::string> only_full(std::vector<std::string> texts) {
  std::erase_if(texts, [](const std::string& text) { return text.empty(); });
  return texts;
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
  const bool is_loss = traffic.dropped_datagrams > told_.dropped_datagrams ||
                       traffic.unclear_datagrams > told_.unclear_datagrams ||
                       traffic.dropped_messages > told_.dropped_messages;
  if (is_loss && log_.admit(now)) {
    told_ = traffic;
    return describe(traffic);
  }
  // On a shared network such datagrams come all the time, so they are logged rarely.
  if (traffic.filtered_datagrams > told_.filtered_datagrams && filter_log_.admit(now)) {
    told_.filtered_datagrams = traffic.filtered_datagrams;
    return describe_filtered(traffic);
  }
  return std::nullopt;
}

std::vector<std::string> LossWatch::find_warnings(const bus::Traffic& traffic,
                                                  const std::vector<std::string>& at_start) {
  std::vector<std::string> warnings = only_full(
      {describe_datagrams(traffic), describe_unclear(traffic), describe_messages(traffic)});
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
  return fmt::format("{}",
                     fmt::join(only_full({describe_datagrams(traffic), describe_unclear(traffic),
                                          describe_messages(traffic), describe_filtered(traffic)}),
                               "; "));
}

}  // namespace quadrille

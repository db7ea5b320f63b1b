#include "process/runtime/watch/other_senders.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <random>

#include "quadrille/bus/status_message.hpp"

namespace quadrille {

const std::string& own_sender() {
  static const std::string sender = [] {
    std::array<char, 64> host{};
    if (gethostname(host.data(), host.size() - 1) != 0) host = {'?'};
    return fmt::format("{}:{}:{:08x}", host.data(), getpid(), std::random_device()());
  }();
  return sender;
}

std::string OtherSenders::describe(const std::string& sender) const {
  return fmt::format(
      "{} publishes on {} too, and its results may be mixed with those of this process ({}); stop "
      "one, or give it channels of its own",
      sender, channel_, own_);
}

void OtherSenders::hear(const std::string& channel, std::span<const std::byte> bytes,
                        Clock::time_point now) {
  const std::string sender =
      bus::read_status_sender(bytes).value_or("a process of another kind or version");
  if (sender == own_) return;
  const std::lock_guard lock(mutex_);
  channel_ = channel;
  std::erase_if(heard_, [&](const auto& entry) { return now - entry.second > kPresence; });
  const auto known = heard_.find(sender);
  if (known != heard_.end()) {
    known->second = now;
  } else if (heard_.size() < kMaxSenders) {
    heard_.emplace(sender, now);
    log_.warning(describe(sender));
  }
}

std::vector<std::string> OtherSenders::find_warnings(Clock::time_point now) const {
  const std::lock_guard lock(mutex_);
  for (const auto& [sender, last] : heard_) {
    if (now - last <= kPresence) return {describe(sender)};
  }
  return {};
}

}  // namespace quadrille

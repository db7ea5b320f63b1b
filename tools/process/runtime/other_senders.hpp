#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "process/runtime/limited_log.hpp"

namespace quadrille {

/// What the status messages of this process name as their sender: its host, its number there, and a
/// random number.
const std::string& own_sender();

/// Listens for other processes that publish their status on this one's channel: their results are
/// likely to get mixed as well. For any thread.
class OtherSenders {
 public:
  using Clock = std::chrono::steady_clock;

  /// For how long after its last message one counts as there.
  static constexpr std::chrono::seconds kPresence{5};
  /// That are kept in mind.
  static constexpr std::size_t kMaxSenders = 8;

  /// @param own  the sender that is this process
  explicit OtherSenders(std::string own = own_sender()) : own_(std::move(own)) {}

  /// Takes a message of the status channel; a sender that was not there is logged.
  void hear(const std::string& channel, std::span<const std::byte> bytes,
            Clock::time_point now = Clock::now());

  /// What is wrong now, for the status: one line, or none.
  std::vector<std::string> find_warnings(Clock::time_point now = Clock::now()) const;

 private:
  std::string describe(const std::string& sender) const;

  const std::string own_;
  mutable std::mutex mutex_;
  std::string channel_;
  std::map<std::string, Clock::time_point> heard_;
  LimitedLog log_;
};

}  // namespace quadrille

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

/// The name of the sender in the status messages of this process: its host, its process id, and a
/// random number.
const std::string& own_sender();

/// Detects other processes that publish their status on this process's channel, because their
/// results are likely to get mixed up as well. For any thread.
class OtherSenders {
 public:
  using Clock = std::chrono::steady_clock;

  /// Time after its last message during which a sender counts as present.
  static constexpr std::chrono::seconds kPresence{5};
  /// Limit of the senders that are remembered.
  static constexpr std::size_t kMaxSenders = 8;

  /// @param own  name of this process as a sender
  explicit OtherSenders(std::string own = own_sender()) : own_(std::move(own)) {}

  /// Receives a message of the status channel; a new sender is logged.
  void hear(const std::string& channel, std::span<const std::byte> bytes,
            Clock::time_point now = Clock::now());

  /// Returns the current warnings for the status: one line, or none.
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

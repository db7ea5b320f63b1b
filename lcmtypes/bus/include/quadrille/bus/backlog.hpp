#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Messages that came faster than they were handled, in their order. For each subscriber only so
/// many bytes wait; what does not fit drives out the oldest of its fullest channel: of several
/// channels a fast one does not drive out what comes on a slow one.
class Backlog {
 public:
  struct Message {
    std::string channel;
    std::vector<std::byte> bytes;
    /// Whose message it is.
    void* subscriber = nullptr;
  };

  /// What a message takes beside its bytes [byte].
  static constexpr std::size_t kOverhead = 256;

  /// @param max_bytes  of one subscriber, with the overhead; its newest message waits in any case
  explicit Backlog(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  QUADRILLE_EXPORT void push(const std::string& channel, std::span<const std::byte> bytes,
                             void* subscriber);

  /// The oldest message; nullopt if none waits.
  QUADRILLE_EXPORT std::optional<Message> pop();

  bool empty() const { return messages_.empty(); }

  /// Messages driven out so far.
  std::int64_t dropped() const { return dropped_; }

 private:
  struct Waiting {
    std::size_t bytes = 0;
    std::map<std::string, std::size_t> by_channel;
  };

  void drop_of_fullest(void* subscriber);
  /// Counts a message no longer.
  void forget(const Message& message);

  std::size_t max_bytes_;
  std::deque<Message> messages_;
  std::map<void*, Waiting> waiting_;
  std::int64_t dropped_ = 0;
};

}  // namespace quadrille::bus

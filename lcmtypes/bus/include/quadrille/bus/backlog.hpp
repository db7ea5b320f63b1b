#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille::bus {

/// Messages that came faster than they were handled, in their order. Of each channel only so many
/// bytes wait; what does not fit drives out the oldest of its channel, never the newest.
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

  /// @param max_bytes  of one channel, with the overhead; its newest message waits in any case
  explicit Backlog(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  void push(const std::string& channel, std::span<const std::byte> bytes, void* subscriber);

  /// The oldest message; nullopt if none waits.
  std::optional<Message> pop();

  bool empty() const { return messages_.empty(); }

  /// Messages driven out so far.
  std::int64_t dropped() const { return dropped_; }

 private:
  void drop_oldest(void* subscriber);

  std::size_t max_bytes_;
  std::deque<Message> messages_;
  /// By subscriber.
  std::map<void*, std::size_t> bytes_;
  std::int64_t dropped_ = 0;
};

}  // namespace quadrille::bus

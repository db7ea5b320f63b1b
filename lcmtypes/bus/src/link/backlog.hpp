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

/// Queue of messages that came faster than they were handled, in their order. The bytes that wait
/// for one subscriber are limited; a message that does not fit drives out the oldest of the fullest
/// channel, so that a fast channel does not drive out messages of a slow one.
class Backlog {
 public:
  struct Message {
    std::string channel;
    std::vector<std::byte> bytes;
    /// The subscriber to whom the message belongs.
    void* subscriber = nullptr;
  };

  /// Memory that a message takes in addition to its bytes [byte].
  static constexpr std::size_t kOverhead = 256;

  /// @param max_bytes  limit for one subscriber, including the overhead; its newest message always
  ///   waits
  explicit Backlog(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  void push(const std::string& channel, std::span<const std::byte> bytes, void* subscriber);

  /// Takes the oldest message; nullopt if none waits.
  std::optional<Message> pop();

  bool empty() const { return messages_.empty(); }

  /// Number of messages driven out so far.
  std::int64_t dropped() const { return dropped_; }

 private:
  struct Waiting {
    std::size_t bytes = 0;
    std::map<std::string, std::size_t> by_channel;
  };

  void drop_of_fullest(void* subscriber);
  /// Removes a message from the counts of waiting bytes.
  void forget(const Message& message);

  std::size_t max_bytes_;
  std::deque<Message> messages_;
  std::map<void*, Waiting> waiting_;
  std::int64_t dropped_ = 0;
};

}  // namespace quadrille::bus

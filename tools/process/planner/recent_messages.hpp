#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille {

/// The last messages of a kind that the detector sends before the quadrics of the same cloud.
/// @tparam Message  with utime, seq and frame
template <class Message>
class RecentMessages {
 public:
  void add(Message message) {
    messages_.push_back(std::move(message));
    if (messages_.size() > kMaxMessages) messages_.pop_front();
  }

  /// Takes the newest message with the utime, seq and frame of the quadrics, and forgets older
  /// ones; nullopt if it has not come, as with a detector that sends none. To be called as soon as
  /// the quadrics have come, since senders that do not tell the time give all clouds the same
  /// stamps.
  std::optional<Message> take(const bus::QuadricsMessage& quadrics) {
    const auto found = std::find_if(messages_.rbegin(), messages_.rend(), [&](const auto& message) {
      return message.utime == quadrics.utime && message.seq == quadrics.seq &&
             message.frame == quadrics.frame;
    });
    if (found == messages_.rend()) return std::nullopt;
    Message message = std::move(*found);
    messages_.erase(messages_.begin(), found.base());
    return message;
  }

 private:
  // Pairing keeps 32 clouds until their quadrics come, so messages on older clouds are of no use.
  static constexpr std::size_t kMaxMessages = 32;

  std::deque<Message> messages_;
};

}  // namespace quadrille

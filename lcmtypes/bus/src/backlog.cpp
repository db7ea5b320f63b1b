#include "quadrille/bus/backlog.hpp"

#include <algorithm>
#include <utility>

namespace quadrille::bus {

void Backlog::push(const std::string& channel, std::span<const std::byte> bytes, void* subscriber) {
  std::size_t& waiting = bytes_[subscriber];
  const std::size_t size = bytes.size() + kOverhead;
  while (waiting > 0 && waiting + size > max_bytes_) drop_oldest(subscriber);
  waiting += size;
  messages_.push_back({channel, {bytes.begin(), bytes.end()}, subscriber});
}

std::optional<Backlog::Message> Backlog::pop() {
  if (messages_.empty()) return std::nullopt;
  Message message = std::move(messages_.front());
  messages_.pop_front();
  bytes_[message.subscriber] -= message.bytes.size() + kOverhead;
  return message;
}

void Backlog::drop_oldest(void* subscriber) {
  const auto oldest = std::find_if(messages_.begin(), messages_.end(), [&](const Message& message) {
    return message.subscriber == subscriber;
  });
  bytes_[subscriber] -= oldest->bytes.size() + kOverhead;
  messages_.erase(oldest);
  ++dropped_;
}

}  // namespace quadrille::bus

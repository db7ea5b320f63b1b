#include "link/backlog.hpp"

#include <algorithm>
#include <utility>

namespace quadrille::bus {

void Backlog::push(const std::string& channel, std::span<const std::byte> bytes, void* subscriber) {
  Waiting& waiting = waiting_[subscriber];
  const std::size_t size = bytes.size() + kOverhead;
  while (waiting.bytes > 0 && waiting.bytes + size > max_bytes_) drop_of_fullest(subscriber);
  waiting.bytes += size;
  waiting.by_channel[channel] += size;
  messages_.push_back({channel, {bytes.begin(), bytes.end()}, subscriber});
}

std::optional<Backlog::Message> Backlog::pop() {
  if (messages_.empty()) return std::nullopt;
  Message message = std::move(messages_.front());
  messages_.pop_front();
  forget(message);
  return message;
}

void Backlog::drop_of_fullest(void* subscriber) {
  const auto& by_channel = waiting_[subscriber].by_channel;
  const auto fullest =
      std::max_element(by_channel.begin(), by_channel.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto oldest = std::find_if(messages_.begin(), messages_.end(), [&](const Message& message) {
    return message.subscriber == subscriber && message.channel == fullest->first;
  });
  forget(*oldest);
  messages_.erase(oldest);
  ++dropped_;
}

void Backlog::forget(const Message& message) {
  const std::size_t size = message.bytes.size() + kOverhead;
  Waiting& waiting = waiting_[message.subscriber];
  waiting.bytes -= size;
  const auto channel = waiting.by_channel.find(message.channel);
  channel->second -= size;
  if (channel->second == 0) waiting.by_channel.erase(channel);
}

}  // namespace quadrille::bus

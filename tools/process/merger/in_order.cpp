#include "process/merger/in_order.hpp"

#include <limits>

namespace quadrille {
namespace {

constexpr std::pair<std::int64_t, std::int32_t> kBeforeAll = {
    std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int32_t>::min()};

}  // namespace

InOrder::InOrder(int shards, std::chrono::milliseconds patience)
    : sources_(static_cast<std::size_t>(shards), Source{kBeforeAll}),
      patience_(patience),
      last_(kBeforeAll) {}

void InOrder::add(int shard, std::int64_t utime, std::int32_t seq, Bytes message,
                  Clock::time_point now) {
  Source& source = sources_.at(static_cast<std::size_t>(shard));
  const Key key(utime, seq);
  // A log that is played again, or a clock that was set back.
  if (key < source.last) restart();
  source = {key, true};
  if (key <= last_ || !waiting_.try_emplace(key, Waiting{std::move(message), now}).second) ++late_;
}

std::vector<InOrder::Bytes> InOrder::take(Clock::time_point now) {
  std::vector<Bytes> due;
  while (!waiting_.empty()) {
    const auto oldest = waiting_.begin();
    if (!is_due(oldest->first, oldest->second, now)) break;
    last_ = oldest->first;
    due.push_back(std::move(oldest->second.message));
    waiting_.erase(oldest);
    ++merged_;
  }
  return due;
}

bool InOrder::is_due(const Key& key, const Waiting& waiting, Clock::time_point now) {
  const bool is_over = now - waiting.since >= patience_;
  bool all_later = true;
  for (Source& source : sources_) {
    if (!source.works || source.last >= key) continue;
    all_later = false;
    if (is_over) source.works = false;
  }
  return all_later || is_over || waiting_.size() > kMaxWaiting;
}

/// What waits belongs to what was before, and all of it is older than what comes.
void InOrder::restart() {
  late_ += static_cast<std::int64_t>(waiting_.size());
  waiting_.clear();
  last_ = kBeforeAll;
  for (Source& source : sources_) source.last = kBeforeAll;
}

}  // namespace quadrille

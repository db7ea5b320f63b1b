#include "process/merger/in_order.hpp"

#include <algorithm>

namespace quadrille {

InOrder::InOrder(int shards, std::chrono::milliseconds patience)
    : sources_(static_cast<std::size_t>(shards)), patience_(patience) {}

void InOrder::see(int shard, Key key, std::int64_t message_digest, std::int64_t cloud_digest) {
  Source& source = sources_.at(static_cast<std::size_t>(shard));
  welcome(shard);
  Cloud cloud;
  cloud.key = key;
  cloud.message_digest = message_digest;
  cloud.cloud_digest = cloud_digest;
  const auto known = find_told(shard, cloud);
  if (!known) {
    begin_anew_if_back(&source, key);
    // Later ones have gone out: its answer will be late.
    if (last_ && key < *last_) return;
  }
  const Position position = known ? *known : insert(shard, cloud);
  Cloud& seen = clouds_[position];
  seen.message_digest = message_digest;
  seen.seen.set(static_cast<std::size_t>(shard));
  if (cloud_digest != 0 && !seen.owner) {
    seen.cloud_digest = cloud_digest;
    seen.owner = shard;
  }
  source.last = key;
  set_told(shard, position);
}

void InOrder::add(int shard, Key key, std::int64_t cloud_digest, Bytes message,
                  Clock::time_point now) {
  Source& source = sources_.at(static_cast<std::size_t>(shard));
  welcome(shard);
  source.state = State::kWorks;
  Cloud cloud;
  cloud.key = key;
  cloud.cloud_digest = cloud_digest;
  cloud.owner = shard;
  auto position = find_owned(shard, cloud);
  if (!position) {
    begin_anew_if_back(&source, key);
    source.last = key;
    if (is_known(cloud) || (last_ && key < *last_)) {
      ++late_;
      return;
    }
    position = insert(shard, cloud);
  }
  Cloud& answered = clouds_[*position];
  answered.owner = shard;
  answered.cloud_digest = cloud_digest;
  answered.answered = true;
  answered.message = std::move(message);
  waiting_bytes_ += answered.message.size();
  answered.since = now;
  set_told(shard, *position);
  // Shards answer in order.
  for (Position i = done_; i < *position; ++i) {
    if (clouds_[i].owner == shard && !clouds_[i].answered) clouds_[i].passed_over = true;
  }
}

/// A shard speaks. One that comes back tells of what comes now, not of clouds that are done, be
/// they ever so alike.
void InOrder::welcome(int shard) {
  const auto which = static_cast<std::size_t>(shard);
  State& state = sources_.at(which).state;
  if (state != State::kUnheard && state != State::kSilent) return;
  state = State::kWorks;
  for (Position i = 0; i < done_; ++i) clouds_[i].told.set(which);
}

/// The first cloud that may be the one a shard tells of, and of which it has not told yet: clouds
/// that are alike in all come one after the other.
std::optional<InOrder::Position> InOrder::find_told(int shard, const Cloud& told) const {
  const auto which = static_cast<std::size_t>(shard);
  for (Position i = 0; i < clouds_.size(); ++i) {
    const Cloud& cloud = clouds_[i];
    if (cloud.key != told.key) continue;
    const bool is_same = cloud.message_digest == 0
                             ? told.cloud_digest == 0 || told.cloud_digest == cloud.cloud_digest
                             : cloud.message_digest == told.message_digest;
    // Of one that it has answered it may tell only now.
    const bool is_new = !cloud.seen[which] && (!cloud.told[which] || cloud.owner == shard);
    if (is_same && is_new) return i;
  }
  return std::nullopt;
}

/// The first cloud that waits for the answer of a shard and may be that one.
std::optional<InOrder::Position> InOrder::find_owned(int shard, const Cloud& answered) const {
  std::optional<Position> nobodys;
  for (Position i = done_; i < clouds_.size(); ++i) {
    const Cloud& cloud = clouds_[i];
    if (cloud.key != answered.key || cloud.answered) continue;
    if (cloud.owner == shard && cloud.cloud_digest == answered.cloud_digest) return i;
    if (!cloud.owner && !nobodys) nobodys = i;
  }
  return nobodys;
}

/// Whether a result is one of a cloud that is done, or has a result already.
bool InOrder::is_known(const Cloud& answered) const {
  const auto begin = clouds_.begin() + static_cast<std::ptrdiff_t>(anew_);
  return std::any_of(begin, clouds_.end(), [&](const Cloud& cloud) {
    return cloud.owner && cloud.key == answered.key && cloud.cloud_digest == answered.cloud_digest;
  });
}

/// Puts a cloud behind the last of which its shard has told, and behind those of its time or
/// before.
InOrder::Position InOrder::insert(int shard, Cloud cloud) {
  const auto which = static_cast<std::size_t>(shard);
  Position position = std::max(done_, anew_);
  for (Position i = position; i < clouds_.size(); ++i) {
    if (clouds_[i].told[which]) position = i + 1;
  }
  while (position < clouds_.size() && clouds_[position].key <= cloud.key) ++position;
  // Who has told of a later one will not tell of this.
  if (position < clouds_.size()) cloud.told = clouds_[position].told;
  clouds_.insert(clouds_.begin() + static_cast<std::ptrdiff_t>(position), std::move(cloud));
  return position;
}

/// A log that is played again, a clock that was set back, or several clocks.
void InOrder::begin_anew_if_back(Source* source, Key key) {
  if (!source->last || key >= *source->last) return;
  anew_ = clouds_.size();
  last_.reset();
  for (Source& each : sources_) each.last.reset();
}

void InOrder::set_told(int shard, Position position) {
  for (Position i = 0; i <= position; ++i) clouds_[i].told.set(static_cast<std::size_t>(shard));
}

bool InOrder::have_all_told(const Cloud& cloud) const {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const bool awaited = sources_[i].state == State::kWorks || sources_[i].state == State::kStuck;
    if (awaited && !cloud.told[i]) return false;
  }
  return true;
}

/// Whether nothing more is to be waited for before what comes after a cloud may go out.
bool InOrder::is_settled(const Cloud& cloud) const {
  if (cloud.answered || !cloud.owner) return have_all_told(cloud);
  return cloud.passed_over ||
         sources_[static_cast<std::size_t>(*cloud.owner)].state != State::kWorks;
}

/// Whether a result has waited for too long.
bool InOrder::has_patience_ended(Clock::time_point now) const {
  return std::any_of(
      clouds_.begin() + static_cast<std::ptrdiff_t>(done_), clouds_.end(),
      [&](const Cloud& cloud) { return cloud.answered && now - cloud.since >= patience_; });
}

/// Nobody waits any more for those who hold up what comes after a cloud.
void InOrder::give_up(const Cloud& cloud) {
  if (cloud.owner && !cloud.answered) {
    sources_[static_cast<std::size_t>(*cloud.owner)].state = State::kStuck;
    return;
  }
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const bool awaited = sources_[i].state == State::kWorks || sources_[i].state == State::kStuck;
    if (awaited && !cloud.told[i]) sources_[i].state = State::kSilent;
  }
}

std::vector<InOrder::Result> InOrder::take(Clock::time_point now) {
  std::vector<Result> due;
  while (const auto next = find_next_answered()) {
    const auto obstacle = find_unsettled(*next);
    if (obstacle && has_patience_ended(now)) {
      give_up(clouds_[*obstacle]);
      continue;
    }
    if (obstacle && !is_too_much()) break;
    for (Position left = *next - done_; left > 0; --left) finish_first();
    Cloud& first = clouds_[done_];
    waiting_bytes_ -= first.message.size();
    due.push_back({std::move(first.message), first.since});
    last_ = first.key;
    finish_first();
  }
  while (clouds_.size() - done_ > kMaxWaiting) finish_first();
  return due;
}

bool InOrder::is_too_much() const {
  return clouds_.size() - done_ > kMaxWaiting || waiting_bytes_ > kMaxWaitingBytes;
}

std::optional<InOrder::Position> InOrder::find_next_answered() const {
  for (Position i = done_; i < clouds_.size(); ++i) {
    if (clouds_[i].answered) return i;
  }
  return std::nullopt;
}

/// The first cloud for which the result at a position still has to wait.
std::optional<InOrder::Position> InOrder::find_unsettled(Position result) const {
  for (Position i = done_; i <= result; ++i) {
    if (!is_settled(clouds_[i])) return i;
  }
  return std::nullopt;
}

void InOrder::finish_first() {
  constexpr std::size_t kKept = 256;
  Cloud& first = clouds_[done_++];
  waiting_bytes_ -= first.message.size();
  first.message = {};
  if (first.answered) {
    ++merged_;
  } else if (first.owner) {
    ++unanswered_;
  }
  if (done_ <= kKept) return;
  clouds_.pop_front();
  --done_;
  if (anew_ > 0) --anew_;
}

}  // namespace quadrille

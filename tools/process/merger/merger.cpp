#include "process/merger/merger.hpp"

#include <fmt/format.h>

#include <utility>

#include "process/runtime/logging.hpp"
#include "process/runtime/shard.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/shard_message.hpp"

namespace quadrille {

Merger::Merger(MergerOptions options, bus::Publish publish)
    : options_(std::move(options)),
      publish_(std::move(publish)),
      results_(options_.shards, std::chrono::milliseconds(options_.patience_ms)) {
  for (int i = 1; i <= options_.shards; ++i) {
    const std::string channel = Shard{i, options_.shards}.channel(options_.channel);
    shards_.push_back({ShardWatch(i, options_.shards, channel)});
  }
}

void Merger::note_heard() {
  if (!first_heard_) first_heard_ = InOrder::Clock::now();
}

void Merger::receive_result(int shard, const std::string& channel,
                            std::span<const std::byte> bytes) {
  ++counts_.received;
  counts_.received_bytes += static_cast<std::int64_t>(bytes.size());
  const bus::Decoded<bus::QuadricsMessage> decoded = bus::decode_quadrics(bytes);
  if (const auto* rejection = std::get_if<bus::Rejection>(&decoded)) {
    refusals_.add(channel, *rejection);
    return;
  }
  note_heard();
  ++shards_.at(static_cast<std::size_t>(shard)).results;
  const auto& message = std::get<bus::QuadricsMessage>(decoded);
  results_.add(shard, {message.utime, message.seq}, message.cloud_digest,
               {bytes.begin(), bytes.end()}, InOrder::Clock::now());
}

void Merger::receive_seen(int shard, const std::string& channel, std::span<const std::byte> bytes) {
  const bus::Decoded<shard_cloud_t> decoded = bus::decode_shard_cloud(bytes);
  if (const auto* rejection = std::get_if<bus::Rejection>(&decoded)) {
    refusals_.add(channel, *rejection);
    return;
  }
  note_heard();
  const auto& message = std::get<shard_cloud_t>(decoded);
  ShardInfo& info = shards_.at(static_cast<std::size_t>(shard));
  if (is_twin(&info, message.sender)) {
    twin_log_.warning(fmt::format(
        "two detectors publish on {}; stop one, or give it another share with --shard", channel));
    return;
  }
  ++info.clouds;
  info.index = message.shard;
  info.shards = message.shards;
  if (const auto mismatch = find_mismatch(info, shard)) mismatch_log_.warning(*mismatch);
  results_.see(shard, {message.utime, message.seq}, message.message_digest, message.cloud_digest);
}

/// Whether a message is of a second process of a shard. One that has begun anew is not: its
/// predecessor is not heard again.
bool Merger::is_twin(ShardInfo* shard, std::int64_t sender) {
  if (sender == shard->sender) return false;
  if (sender == shard->previous_sender) return true;
  shard->previous_sender = std::exchange(shard->sender, sender);
  return false;
}

/// @param index  of the channel on which the shard is heard, from 0
std::optional<std::string> Merger::find_mismatch(const ShardInfo& shard, int index) const {
  if (shard.shards == 0) return std::nullopt;
  if (shard.shards == options_.shards && shard.index == index + 1) return std::nullopt;
  return fmt::format(
      "the detector on {} has --shard {}/{}, where --shards {} expects {}/{}: clouds will be "
      "missing or out of order; give all detectors and the merge the same N",
      Shard{index + 1, options_.shards}.channel(options_.channel), shard.index, shard.shards,
      options_.shards, index + 1, options_.shards);
}

void Merger::publish_due() {
  const auto now = InOrder::Clock::now();
  for (const InOrder::Result& result : results_.take(now)) {
    publish_(options_.channel, result.message);
    ++counts_.published;
    counts_.published_bytes += static_cast<std::int64_t>(result.message.size());
    stages_.add("wait", std::chrono::duration<double, std::milli>(now - result.since).count());
  }
  for (std::size_t i = 0; i < shards_.size(); ++i) {
    const InOrder::State state = results_.state(static_cast<int>(i));
    const auto record = shards_[i].watch.update(state, first_heard_, now);
    if (!record) continue;
    state == InOrder::State::kWorks ? log_info(*record) : log_warning(*record);
  }
}

}  // namespace quadrille

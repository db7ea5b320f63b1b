#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace quadrille {

/// The share of one of several detectors in a stream of clouds.
struct Shard {
  /// From 1 to count.
  int index = 1, count = 1;

  bool is_whole() const { return count == 1; }

  /// Whether a message is this detector's to answer. That follows from its bytes alone: all
  /// detectors, on whatever machine, agree, and of N of them each message has exactly one. Clouds
  /// with a number (seq) are dealt out in turns, others by their content, in the mean evenly.
  bool takes(std::span<const std::byte> message) const;

  /// The channel of this shard's results: "NAME_I", or NAME if the shard is the whole.
  std::string channel(const std::string& name) const;

  /// The channel on which this shard tells which clouds it has received: "NAME_I_SEEN".
  std::string seen_channel(const std::string& name) const { return channel(name) + "_SEEN"; }
};

inline constexpr int kMaxShards = 64;

/// Reads "I/N", with 1 <= I <= N <= kMaxShards.
/// @throws std::invalid_argument if it is not that
Shard parse_shard(const std::string& text);

}  // namespace quadrille

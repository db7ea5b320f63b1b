#include "process/runtime/shard.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <stdexcept>

#include "io/hash.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {

namespace {

/// Deals clouds out in turns by the number that their source gives them: steps of the golden ratio
/// around a circle fall evenly, also if the source leaves out every second number.
std::uint64_t share_of_number(std::int32_t seq, int count) {
  constexpr std::uint32_t kGoldenRatio = 0x9e3779b9;
  const std::uint32_t angle = static_cast<std::uint32_t>(seq) * kGoldenRatio;
  return (angle * static_cast<std::uint64_t>(count)) >> 32;
}

std::uint64_t share_of(std::span<const std::byte> message, int count) {
  const auto stamp = bus::read_stamp(message);
  // A source that does not count leaves 0.
  if (stamp && stamp->seq != 0) return share_of_number(stamp->seq, count);
  return io::hash_of(message) % static_cast<std::uint64_t>(count);
}

}  // namespace

bool Shard::takes(std::span<const std::byte> message) const {
  return is_whole() || share_of(message, count) == static_cast<std::uint64_t>(index - 1);
}

std::string Shard::channel(const std::string& name) const {
  return is_whole() || name.empty() ? name : fmt::format("{}_{}", name, index);
}

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool has_slash = index.ec == std::errc{} && index.ptr != end && *index.ptr == '/';
  const auto count = std::from_chars(has_slash ? index.ptr + 1 : end, end, shard.count);
  if (count.ec != std::errc{} || count.ptr != end || shard.index < 1 || shard.count < shard.index ||
      shard.count > kMaxShards) {
    throw std::invalid_argument(
        fmt::format("shard '{}': must be I/N with 1 <= I <= N <= {}", printable(text), kMaxShards));
  }
  return shard;
}

}  // namespace quadrille

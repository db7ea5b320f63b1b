#include "process/runtime/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "quadrille/bus/cloud_message.hpp"

namespace quadrille {

/// FNV-1a over words, ended by splitmix64's mixing so that the remainder by a small N is even.
std::int64_t digest_of_message(std::span<const std::byte> bytes) {
  std::uint64_t state = 0xcbf29ce484222325;
  // The head, with its time and number, and a thousandth of the rest: clouds that tell the same
  // time differ there.
  constexpr std::size_t kHead = 256, kSamples = 512, kWord = sizeof(std::uint64_t);
  const std::size_t step = std::max(kWord, bytes.size() / kSamples / kWord * kWord);
  for (std::size_t at = 0; at + kWord <= bytes.size(); at += at < kHead ? kWord : step) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, kWord);
    state = (state ^ word) * 0x100000001b3;
    state ^= state >> 32;
  }
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9;
  state = (state ^ (state >> 27)) * 0x94d049bb133111eb;
  return static_cast<std::int64_t>(state ^ (state >> 31));
}

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
  return static_cast<std::uint64_t>(digest_of_message(message)) % static_cast<std::uint64_t>(count);
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
        fmt::format("shard '{}': must be I/N with 1 <= I <= N <= {}", text, kMaxShards));
  }
  return shard;
}

}  // namespace quadrille

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// Puts the results of several shards into the order of their clouds.
///
/// Each shard answers its clouds in order. A result waits until every shard that works has told a
/// later one, or for as long as the patience: a shard that was silent so long while others spoke is
/// taken for lost, and nobody waits for it until it speaks again.
class InOrder {
 public:
  using Clock = std::chrono::steady_clock;
  using Bytes = std::vector<std::byte>;

  InOrder(int shards, std::chrono::milliseconds patience);

  /// Results that wait at the most; with more the oldest goes out.
  static constexpr std::size_t kMaxWaiting = 256;

  /// @param shard  from 0
  /// @param utime  of the cloud [us]
  /// @param seq    of the cloud
  void add(int shard, std::int64_t utime, std::int32_t seq, Bytes message, Clock::time_point now);

  /// The results that are due, in order.
  std::vector<Bytes> take(Clock::time_point now);

  std::int64_t merged() const { return merged_; }
  /// Results that came after a later one had gone out, or a second time: they are dropped.
  std::int64_t late() const { return late_; }

 private:
  using Key = std::pair<std::int64_t, std::int32_t>;
  struct Waiting {
    Bytes message;
    Clock::time_point since;
  };
  struct Source {
    Key last;
    bool works = false;
  };

  bool is_due(const Key& key, const Waiting& waiting, Clock::time_point now);
  void restart();

  std::vector<Source> sources_;
  std::chrono::milliseconds patience_;
  std::map<Key, Waiting> waiting_;
  Key last_;
  std::int64_t merged_ = 0, late_ = 0;
};

}  // namespace quadrille

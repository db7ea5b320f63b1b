#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "process/merger/in_order.hpp"
#include "quadrille/bus/rate_limiter.hpp"

namespace quadrille {

/// Tells when a shard is lost and when it is back: a pair of records every ten seconds at most.
class ShardWatch {
 public:
  using Clock = InOrder::Clock;

  /// How long a shard may be unheard while others speak, before that is told.
  static constexpr std::chrono::seconds kStart{3};

  /// @param shard  from 1, of so many
  /// @param channel  of its results
  ShardWatch(int shard, int shards, std::string channel);

  /// Takes note of a shard's state.
  /// @param others_heard_since  when the first shard was heard; none: none was
  /// @return a record for the log, if there is something to tell
  std::optional<std::string> update(InOrder::State state,
                                    std::optional<Clock::time_point> others_heard_since,
                                    Clock::time_point now);

  /// What is wrong with the shard now; nullopt if nothing is.
  std::optional<std::string> describe() const;

  /// How often the shard was lost.
  std::int64_t times_lost() const { return times_lost_; }

 private:
  std::string name_, channel_;
  InOrder::State state_ = InOrder::State::kUnheard;
  bool is_lost_ = false, is_told_ = false;
  std::int64_t times_lost_ = 0;
  bus::RateLimiter log_{std::chrono::seconds(10)};
};

/// "works", "unheard", "silent" or "stuck".
std::string to_string(InOrder::State state);

}  // namespace quadrille

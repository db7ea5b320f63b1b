#pragma once

#include <bitset>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "process/runtime/shard.hpp"

namespace quadrille {

/// Puts the results of several shards into the order in which their clouds came.
///
/// Each shard tells of every cloud that it receives, its own or another's, and answers its own,
/// both in order. A result goes out once every shard has told of its cloud or a later one, and
/// every cloud before it has been answered or passed over. A shard that holds others up for as long
/// as the patience is not waited for until it speaks again. What only a result tells of is ordered
/// by its time.
class InOrder {
 public:
  using Clock = std::chrono::steady_clock;
  using Bytes = std::vector<std::byte>;
  /// The utime [us] and seq of a cloud.
  using Key = std::pair<std::int64_t, std::int32_t>;

  /// What is known of a shard. Results wait only for one that works.
  enum class State {
    kUnheard,  ///< nothing has come yet
    kWorks,
    kSilent,  ///< others told of clouds, this one did not
    kStuck,   ///< it took a cloud and does not answer
  };

  struct Result {
    Bytes message;
    Clock::time_point since;
  };

  InOrder(int shards, std::chrono::milliseconds patience);

  /// Clouds that wait at the most, with or without their results; with more the oldest goes.
  static constexpr std::size_t kMaxWaiting = 256;
  /// What the results that wait take at the most; with more the oldest goes [byte].
  static constexpr std::size_t kMaxWaitingBytes = 64 << 20;

  /// A shard tells that it has received a cloud.
  /// @param shard           from 0
  /// @param message_digest  of the cloud's message
  /// @param cloud_digest    of its points if it is this shard's to answer, else 0
  void see(int shard, Key key, std::int64_t message_digest, std::int64_t cloud_digest);

  /// A shard answers a cloud.
  void add(int shard, Key key, std::int64_t cloud_digest, Bytes message, Clock::time_point now);

  /// The results that are due, in order.
  std::vector<Result> take(Clock::time_point now);

  State state(int shard) const { return sources_.at(static_cast<std::size_t>(shard)).state; }
  std::int64_t merged() const { return merged_; }
  /// Results that came after a later one had gone out, or a second time: they are dropped.
  std::int64_t late() const { return late_; }
  /// Clouds that a shard took and did not answer in time.
  std::int64_t unanswered() const { return unanswered_; }

 private:
  struct Source {
    State state = State::kUnheard;
    /// Of its last cloud.
    std::optional<Key> last;
  };
  struct Cloud {
    Key key;
    /// 0 if not known.
    std::int64_t message_digest = 0, cloud_digest = 0;
    /// Who is to answer it; none if not known.
    std::optional<int> owner;
    bool answered = false, passed_over = false;
    Bytes message;
    Clock::time_point since;
    /// Shards that have told of this cloud, and of this or a later one.
    std::bitset<kMaxShards> seen, told;
  };
  using Position = std::size_t;

  void welcome(int shard);
  std::optional<Position> find_told(int shard, const Cloud& told) const;
  std::optional<Position> find_owned(int shard, const Cloud& answered) const;
  bool is_known(const Cloud& answered) const;
  Position insert(int shard, Cloud cloud);
  void begin_anew_if_back(Source* source, Key key);
  void set_told(int shard, Position position);
  bool have_all_told(const Cloud& cloud) const;
  bool is_settled(const Cloud& cloud) const;
  std::optional<Position> find_next_answered() const;
  std::optional<Position> find_unsettled(Position result) const;
  bool has_patience_ended(Clock::time_point now) const;
  void give_up(const Cloud& cloud);
  bool is_too_much() const;
  void finish_first();

  std::vector<Source> sources_;
  std::chrono::milliseconds patience_;
  /// Those that are done, of which some are kept to know what comes late, and then those that wait.
  std::deque<Cloud> clouds_;
  Position done_ = 0;
  /// Of the results that wait.
  std::size_t waiting_bytes_ = 0;
  /// Where time ran backwards last: what comes now belongs behind it.
  Position anew_ = 0;
  /// Of the last result that went out since then.
  std::optional<Key> last_;
  std::int64_t merged_ = 0, late_ = 0, unanswered_ = 0;
};

}  // namespace quadrille

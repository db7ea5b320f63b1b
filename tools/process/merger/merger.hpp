#pragma once

#include <cstdint>
#include <lcmtypes/quadrille/merger_status_t.hpp>
#include <lcmtypes/quadrille/shard_cloud_t.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "process/merger/in_order.hpp"
#include "process/merger/shard_watch.hpp"
#include "process/runtime/limited_log.hpp"
#include "process/runtime/rate.hpp"
#include "process/runtime/refusals.hpp"
#include "process/runtime/stages.hpp"
#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/publish.hpp"

namespace quadrille {

/// What to merge.
struct MergerOptions {
  /// Shards publish on CHANNEL_1, CHANNEL_2, …; the merger on CHANNEL.
  std::string channel = "QUADRICS";
  std::string status_channel = "QUADRILLE_MERGER_STATUS";
  int shards = 2;
  /// How long a result waits for those before it [ms].
  int patience_ms = 500;
};

/// Puts the results of detectors that share a stream on one channel, in the order of the clouds.
/// For one thread.
class Merger {
 public:
  Merger(MergerOptions options, bus::Publish publish);

  /// Takes a message of one of the channels of a shard.
  void receive_result(int shard, const std::string& channel, std::span<const std::byte> bytes);
  void receive_seen(int shard, const std::string& channel, std::span<const std::byte> bytes);

  /// Publishes what is due.
  void publish_due();

  /// @param warnings  what is wrong with the transport
  /// @return the same in the text format that Prometheus reads
  std::string publish_status(const bus::Traffic& traffic, std::vector<std::string> warnings);

  std::string summary() const;

 private:
  struct ShardInfo {
    ShardWatch watch;
    std::int64_t clouds = 0, results = 0;
    /// That it was started with, and who it is; 0: not known.
    std::int32_t index = 0, shards = 0;
    std::int64_t sender = 0, previous_sender = 0;
  };

  void note_heard();
  bool is_twin(ShardInfo* shard, std::int64_t sender);
  std::optional<std::string> find_mismatch(const ShardInfo& shard, int index) const;
  std::vector<std::string> find_warnings() const;
  void fill_counts(merger_status_t* status);

  MergerOptions options_;
  bus::Publish publish_;
  InOrder results_;
  std::vector<ShardInfo> shards_;
  std::optional<InOrder::Clock::time_point> first_heard_;
  Refusals refusals_;
  LimitedLog mismatch_log_, twin_log_;
  merger_status_t counts_{};
  Rate received_rate_, published_rate_;
  Stages stages_{{"wait"}};
};

}  // namespace quadrille

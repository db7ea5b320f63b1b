// What the merger tells of itself: status messages, statistics, the last line of a run.
#include <fmt/format.h>

#include <utility>

#include "process/merger/merger.hpp"
#include "process/runtime/exposition.hpp"
#include "process/runtime/other_senders.hpp"
#include "process/runtime/process_info.hpp"
#include "process/runtime/status.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille {
namespace {

std::string hash_of(const MergerOptions& options) {
  SettingsText text;
  text.add("channel", options.channel);
  text.add("status_channel", options.status_channel);
  text.add("shards", std::to_string(options.shards));
  text.add("patience", std::to_string(options.patience_ms));
  return text.hash();
}

count_t labelled(const shard_state_t& shard, std::int64_t count) {
  count_t entry;
  entry.name = std::to_string(shard.shard);
  entry.count = count;
  return entry;
}

std::string to_exposition(const merger_status_t& status, const MergerOptions& options) {
  Exposition out("quadrille_merger",
                 {{"channel", options.channel}, {"status_channel", options.status_channel}});
  out.add_counter("results_received", "Messages of quadrics, of all shards.", status.received);
  out.add_counter("results_published", "Of these, those that went on.", status.published);
  out.add_counter("results_late", "Dropped: after a later one, or a second time.", status.late);
  out.add_counter("clouds_unanswered", "Clouds that a shard took and did not answer in time.",
                  status.unanswered);
  out.add_counters("messages_refused", "Messages refused.", status.rejected);
  std::vector<count_t> works, clouds, results, lost;
  for (const shard_state_t& shard : status.shards) {
    works.push_back(labelled(shard, shard.state == "works" ? 1 : 0));
    clouds.push_back(labelled(shard, shard.clouds));
    results.push_back(labelled(shard, shard.results));
    lost.push_back(labelled(shard, shard.times_lost));
  }
  out.add_gauges("shard_works", "Whether results wait for a shard.", "shard", works);
  out.add_counters("shard_clouds", "Clouds that a shard told of.", clouds, "shard");
  out.add_counters("shard_results", "Messages of quadrics of a shard.", results, "shard");
  out.add_counters("shard_lost", "How often a shard was lost.", lost, "shard");
  out.add_gauge("results_per_second", "Over the last ten seconds.", status.published_rate);
  out.add_common(status);
  return out.text();
}

}  // namespace

std::vector<std::string> Merger::find_warnings() const {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < shards_.size(); ++i) {
    if (auto loss = shards_[i].watch.describe()) warnings.push_back(std::move(*loss));
    if (auto mismatch = find_mismatch(shards_[i], static_cast<int>(i))) {
      warnings.push_back(std::move(*mismatch));
    }
  }
  return warnings;
}

void Merger::fill_counts(merger_status_t* status) {
  *status = counts_;
  status->utime = bus::wall_clock_utime();
  status->sender = own_sender();
  status->late = results_.late();
  status->unanswered = results_.unanswered();
  status->received_rate = received_rate_.update(counts_.received);
  status->published_rate = published_rate_.update(counts_.published);
  status->process = describe_process(hash_of(options_));
  status->rejected = bus::to_message(refusals_.counts());
  status->num_rejected = static_cast<std::int32_t>(status->rejected.size());
  for (std::size_t i = 0; i < shards_.size(); ++i) {
    shard_state_t& shard = status->shards.emplace_back();
    shard.shard = static_cast<std::int32_t>(i) + 1;
    shard.state = to_string(results_.state(static_cast<int>(i)));
    shard.clouds = shards_[i].clouds;
    shard.results = shards_[i].results;
    shard.times_lost = shards_[i].watch.times_lost();
    shard.shards = shards_[i].shards;
  }
  status->num_shards = static_cast<std::int32_t>(status->shards.size());
  set_stages(stages_, status);
}

std::string Merger::publish_status(const bus::Traffic& traffic, std::vector<std::string> warnings) {
  merger_status_t status;
  fill_counts(&status);
  status.transport = to_message(traffic);
  for (std::string& warning : find_warnings()) warnings.push_back(std::move(warning));
  status.warnings = std::move(warnings);
  status.num_warnings = static_cast<std::int32_t>(status.warnings.size());
  publish_(options_.status_channel, bus::encode(status));
  return to_exposition(status, options_);
}

std::string Merger::summary() const {
  return fmt::format("{} results merged, {} late or twice, {}; clouds not answered in time: {}",
                     results_.merged(), results_.late(), describe(refusals_.counts()),
                     results_.unanswered());
}

}  // namespace quadrille

#include "process/merger/run_merger.hpp"

#include <string>
#include <vector>

#include "process/runtime/log_listening.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/loss_watch.hpp"
#include "process/runtime/other_senders.hpp"
#include "process/runtime/respawn.hpp"
#include "process/runtime/stats_file.hpp"
#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/receiver.hpp"
#include "quadrille/bus/stop.hpp"
#include "quadrille/bus/ticker.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille {
namespace {

/// @return the channels of the results
std::vector<std::string> subscribe(const MergerOptions& options, bus::Connection* connection,
                                   Merger* merger) {
  std::vector<std::string> channels;
  for (int i = 0; i < options.shards; ++i) {
    const Shard shard{i + 1, options.shards};
    const std::string results = shard.channel(options.channel);
    connection->subscribe(results, [=](const std::string& name, std::span<const std::byte> bytes) {
      merger->receive_result(i, name, bytes);
    });
    connection->subscribe(shard.seen_channel(options.channel),
                          [=](const std::string& name, std::span<const std::byte> bytes) {
                            merger->receive_seen(i, name, bytes);
                          });
    channels.push_back(results);
  }
  return channels;
}

void publish_status(const bus::Connection& connection, const OtherSenders& others, StatsFile* stats,
                    Merger* merger) {
  const bus::Traffic traffic = connection.traffic();
  std::vector<std::string> warnings = LossWatch::find_warnings(traffic, connection.warnings());
  for (std::string& warning : others.find_warnings()) warnings.push_back(std::move(warning));
  stats->write(merger->publish_status(traffic, std::move(warnings)));
}

}  // namespace

void run_merger(const MergerSettings& settings) {
  start_logging("quadrille-merge", settings.process.verbose);
  if (settings.process.respawn) {
    // What can be told now is not to be tried again and again.
    StatsFile(settings.process.stats_file);
    respawn();
  }
  bus::install_stop_signals();
  StatsFile stats(settings.process.stats_file);
  const std::string url = bus::resolve_url(settings.process.lcm_url);
  bus::Connection connection(url, bus::parse_senders(settings.process.accept_from));
  for (const std::string& warning : connection.warnings()) log_warning(warning);
  Merger merger(settings.merger, [&](const std::string& channel, std::span<const std::byte> bytes) {
    connection.publish(channel, bytes);
  });
  log_listening(subscribe(settings.merger, &connection, &merger), url, connection);
  OtherSenders others;
  connection.subscribe(
      settings.merger.status_channel,
      [&](const std::string& name, std::span<const std::byte> bytes) { others.hear(name, bytes); });
  LossWatch losses;
  bus::Ticker loss_tick(std::chrono::milliseconds(50)), status_tick(std::chrono::seconds(1));
  bus::EndlessHandler handler(connection);
  constexpr int kWaitMs = 10;
  while (!bus::stop_requested()) {
    handler.handle(kWaitMs);
    merger.publish_due();
    if (loss_tick.due()) {
      if (const auto loss = losses.check(connection.traffic())) log_warning(*loss);
    }
    if (status_tick.due()) publish_status(connection, others, &stats, &merger);
  }
  publish_status(connection, others, &stats, &merger);
  const std::string lost = LossWatch::describe(connection.traffic());
  if (!lost.empty()) log_warning("in all " + lost);
  log_info("stopped: " + merger.summary());
}

}  // namespace quadrille

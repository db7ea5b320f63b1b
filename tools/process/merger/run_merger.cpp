#include "process/merger/run_merger.hpp"

#include <fmt/format.h>

#include "process/merger/in_order.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/refusals.hpp"
#include "process/runtime/respawn.hpp"
#include "process/runtime/shard.hpp"
#include "quadrille/bus/connection.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/stop.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille {
namespace {

/// Takes a shard's message if it holds quadrics.
void receive(int shard, const std::string& channel, std::span<const std::byte> bytes,
             Refusals* refusals, InOrder* results) {
  const bus::Decoded<bus::QuadricsMessage> decoded = bus::decode_quadrics(bytes);
  if (const auto* rejection = std::get_if<bus::Rejection>(&decoded)) {
    refusals->add(channel, *rejection);
    return;
  }
  const auto& message = std::get<bus::QuadricsMessage>(decoded);
  results->add(shard, message.utime, message.seq, {bytes.begin(), bytes.end()},
               InOrder::Clock::now());
}

}  // namespace

void run_merger(const MergerSettings& settings) {
  start_logging("quadrille-merge", settings.process.verbose);
  if (settings.process.respawn) respawn();
  bus::install_stop_signals();
  bus::Connection connection(bus::resolve_url(settings.process.lcm_url),
                             bus::parse_senders(settings.process.accept_from));
  for (const std::string& warning : connection.warnings()) log_warning(warning);
  InOrder results(settings.shards, std::chrono::milliseconds(settings.patience_ms));
  Refusals refusals;
  for (int i = 0; i < settings.shards; ++i) {
    const std::string channel = Shard{i + 1, settings.shards}.channel(settings.channel);
    connection.subscribe(channel,
                         [&, i](const std::string& name, std::span<const std::byte> bytes) {
                           receive(i, name, bytes, &refusals, &results);
                         });
    log_info(fmt::format("listening to {} on {}", channel, connection.url()));
  }
  constexpr int kWaitMs = 10;
  while (!bus::stop_requested()) {
    connection.handle(kWaitMs);
    for (const auto& message : results.take(InOrder::Clock::now())) {
      connection.publish(settings.channel, message);
    }
  }
  log_info(fmt::format("stopped: {} results merged, {} late or twice, {}", results.merged(),
                       results.late(), describe(refusals.counts())));
}

}  // namespace quadrille

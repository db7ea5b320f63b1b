#include "quadrille/merge_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "process/merger/run_merger.hpp"
#include "process/runtime/shard.hpp"

namespace quadrille {

void add_merge_command(CLI::App& app) {
  auto settings = std::make_shared<MergerSettings>();
  CLI::App* command =
      app.add_subcommand("merge", "Put the results of detectors with --shard I/N into order, live");
  settings->process.add_bus_to(*command);
  settings->process.add_stats_to(*command);
  command->add_option("--shards", settings->merger.shards, "How many detectors share the stream")
      ->check(CLI::Range(2, kMaxShards))
      ->type_name("N")
      ->required();
  add_channel_option(*command, "--out-channel", settings->merger.channel, "quadrics");
  add_channel_option(*command, "--status-channel", settings->merger.status_channel, "status");
  command->add_option("--patience", settings->merger.patience_ms, "Wait so long for a shard [ms]")
      ->check(CLI::Range(1, 60000))
      ->type_name("MS")
      ->capture_default_str();
  command->callback([settings] {
    settings->process.check();
    settings->merger.channel = settings->process.prefixed(settings->merger.channel);
    settings->merger.status_channel = settings->process.prefixed(settings->merger.status_channel);
    check_distinct({{"--out-channel", settings->merger.channel},
                    {"--status-channel", settings->merger.status_channel}});
    run_merger(*settings);
  });
}

}  // namespace quadrille

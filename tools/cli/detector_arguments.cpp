#include "cli/detector_arguments.hpp"

#include <CLI/CLI.hpp>
#include <utility>

#include "cli/seed_option.hpp"
#include "cli/types_option.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille {
namespace {

/// Returns the bounds of the option `threads`.
CLI::Range thread_range() {
  CLI::Range range(0, 0);
  const DetectorOptions options;
  DetectorOptions::visit(options, [&](const auto& field, const Setting& setting) {
    if (static_cast<const void*>(&field) != &options.threads) return;
    range = CLI::Range(static_cast<int>(setting.min), static_cast<int>(setting.max));
  });
  return range;
}

}  // namespace

void DetectorArguments::add_to(CLI::App& command) {
  command.add_option("--config", config, "Settings (TOML)")->type_name("FILE");
  add_types_option(command, "--only", only,
                   "Find only these types; where grasps are planned the same as --report");
  add_types_option(command, "--report", report,
                   "Show and grasp only these types; the others stay in the way");
  command.get_option("--report")->excludes("--only");
  add_seed_option(command, seed, "the random stream");
  command.add_option("--threads", threads, "Threads to use; never changes the result")
      ->type_name("N")
      ->check(thread_range());
}

DetectorOptions DetectorArguments::over(DetectorOptions options) const {
  if (seed) options.seed = *seed;
  if (threads) options.threads = *threads;
  if (!only.empty()) options.only = only;
  if (!report.empty()) options.report = report;
  return options;
}

DetectorSetup DetectorArguments::overrule(io::DetectorConfig file) const {
  if (!only.empty()) file.detector.only = only;
  return {over(io::search_options(file)), file.track};
}

DetectorSetup DetectorArguments::overrule_for_planning(const io::DetectorConfig& file) const {
  DetectorSetup setup{over(file.detector), file.track};
  DetectorOptions& options = setup.options;
  // The command line takes precedence over the file's own report.
  if (!only.empty() || options.report.empty()) options.report = std::move(options.only);
  options.only.clear();
  return setup;
}

}  // namespace quadrille

#include "cli/detector_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <set>

#include "cli/seed_option.hpp"
#include "cli/types_option.hpp"
#include "io/settings/setting_text.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille {
namespace {

/// Lists the settings given in a file that the search for spheres alone overrides.
std::vector<std::string> overruled_for_spheres(const DetectorOptions& options,
                                               const std::set<std::string>& given) {
  std::map<std::string, std::string> before;
  DetectorOptions::visit(options, [&](const auto& field, const Setting& setting) {
    before[setting.name] = io::toml_of(field);
  });
  std::vector<std::string> names;
  const DetectorOptions used = sphere_options(options);
  DetectorOptions::visit(used, [&](const auto& field, const Setting& setting) {
    const bool changed = io::toml_of(field) != before[setting.name];
    if (changed && given.count(setting.name)) names.emplace_back(setting.name);
  });
  return names;
}

/// Warns of settings that the search for spheres alone ignores.
void warn_of_unheeded(const io::DetectorConfig& file, DetectorSetup* setup) {
  if (!seeks_spheres_alone(setup->options)) return;
  const std::vector<std::string> names = overruled_for_spheres(setup->options, file.given);
  if (names.empty()) return;
  setup->warnings.push_back(
      fmt::format("--only sphere sets search, families and density itself; not as given: {}",
                  fmt::join(names, ", ")));
}

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

DetectorSetup DetectorArguments::given(const io::DetectorConfig& file) const {
  DetectorSetup setup{file.detector, file.track, {}};
  DetectorOptions& options = setup.options;
  if (seed) options.seed = *seed;
  if (threads) options.threads = *threads;
  if (!only.empty()) options.only = only;
  if (!report.empty()) options.report = report;
  return setup;
}

DetectorSetup DetectorArguments::overrule(const io::DetectorConfig& file) const {
  DetectorSetup setup = given(file);
  warn_of_unheeded(file, &setup);
  return setup;
}

DetectorSetup DetectorArguments::overrule_for_planning(const io::DetectorConfig& file) const {
  DetectorSetup setup = given(file);
  DetectorOptions& options = setup.options;
  // The command line takes precedence over the file's own report.
  if (!only.empty() || options.report.empty()) options.report = std::move(options.only);
  options.only.clear();
  return setup;
}

}  // namespace quadrille

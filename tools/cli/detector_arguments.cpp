#include "cli/detector_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <set>
#include <sstream>

#include "cli/seed_option.hpp"
#include "io/setting_text.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille {
namespace {

std::vector<QuadricType> types_of(const std::string& list) {
  std::vector<QuadricType> types;
  std::istringstream in(list);
  for (std::string name; std::getline(in, name, ',');) {
    if (const auto type = quadric_type_from_string(name)) types.push_back(*type);
  }
  return types;
}

/// Empty if all names of the list are types that can be found, else what is wrong.
std::string check_types(const std::string& list) {
  std::istringstream in(list);
  int count = 0;
  for (std::string name; std::getline(in, name, ','); ++count) {
    const auto type = quadric_type_from_string(name);
    if (type && !word_of(*type).empty()) continue;
    return (type ? "type '" + name + "' is never found" : "unknown type '" + name + "'") +
           "; the types are " + io::list_words<QuadricType>();
  }
  return count > 0 ? "" : "names no type";
}

/// The settings that the search for spheres alone changes, of those that a file gives.
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

/// The bounds of the option `threads`.
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
  command.add_option("--only", only, "Report only these types, separated by commas")
      ->type_name("TYPE,...")
      ->check(CLI::Validator(check_types, ""));
  add_seed_option(command, seed, "the random stream");
  command.add_option("--threads", threads, "Threads to use; never changes the result")
      ->type_name("N")
      ->check(thread_range());
}

DetectorSetup DetectorArguments::overrule(const io::DetectorConfig& file) const {
  DetectorSetup setup{file.detector, file.track, {}};
  DetectorOptions& options = setup.options;
  if (seed) options.seed = *seed;
  if (threads) options.threads = *threads;
  if (!only.empty()) options.only = types_of(only);
  if (!seeks_spheres_alone(options)) return setup;
  const std::vector<std::string> names = overruled_for_spheres(options, file.given);
  if (!names.empty()) {
    setup.warnings.push_back(
        fmt::format("--only sphere sets search, families and density itself; not as given: {}",
                    fmt::join(names, ", ")));
  }
  return setup;
}

}  // namespace quadrille

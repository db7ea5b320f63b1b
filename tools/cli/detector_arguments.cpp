#include "cli/detector_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <sstream>

#include "cli/seed_option.hpp"
#include "io/config.hpp"
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

/// False for what no points can show: imaginary quadrics, and a plane doubled onto itself, which is
/// reported as a plane.
bool is_reported(QuadricType type) {
  return !is_imaginary(type) && type != QuadricType::kCoincidentPlanes;
}

/// Empty if all names of the list are types that can be found, else what is wrong.
std::string check_types(const std::string& list) {
  std::istringstream in(list);
  int count = 0;
  for (std::string name; std::getline(in, name, ','); ++count) {
    const auto type = quadric_type_from_string(name);
    if (type && is_reported(*type)) continue;
    std::string all;
    for (const QuadricType one : all_quadric_types()) {
      if (is_reported(one)) all += (all.empty() ? "" : ", ") + std::string(to_string(one));
    }
    return (type ? "type '" + name + "' is never found" : "unknown type '" + name + "'") +
           "; the types are " + all;
  }
  return count > 0 ? "" : "names no type";
}

/// The settings that the search for spheres alone changes, of those that a file gives.
std::vector<std::string> overruled_for_spheres(const io::Settings& settings) {
  std::vector<std::string> names;
  std::map<std::string, double> before;
  DetectorOptions given = settings.detector, used = sphere_options(given);
  visit_options(given,
                [&](const char* name, auto& field) { before[name] = static_cast<double>(field); });
  visit_options(used, [&](const char* name, auto& field) {
    const bool changed = static_cast<double>(field) != before[name];
    if (changed && settings.given.count(name)) names.emplace_back(name);
  });
  return names;
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
      ->check(CLI::Range(1, 256));
}

DetectorOptions DetectorArguments::options() const {
  DetectorOptions options = config.empty() ? DetectorOptions() : io::load_settings(config).detector;
  if (seed) options.seed = *seed;
  if (threads) options.threads = *threads;
  if (!only.empty()) options.only = types_of(only);
  return options;
}

TrackOptions DetectorArguments::track_options() const {
  return config.empty() ? TrackOptions() : io::load_settings(config).track;
}

std::vector<std::string> DetectorArguments::warnings() const {
  if (config.empty() || !seeks_spheres_alone(options())) return {};
  const std::vector<std::string> names = overruled_for_spheres(io::load_settings(config));
  if (names.empty()) return {};
  return {fmt::format("--only sphere sets search, families and density itself; not as given: {}",
                      fmt::join(names, ", "))};
}

}  // namespace quadrille

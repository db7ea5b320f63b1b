#include "cli/detector_arguments.hpp"

#include <CLI/CLI.hpp>
#include <sstream>
#include <vector>

#include "io/config.hpp"

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

/// Empty if all names of the list are types, else what is wrong.
std::string check_types(const std::string& list) {
  std::istringstream in(list);
  int count = 0;
  for (std::string name; std::getline(in, name, ','); ++count) {
    if (quadric_type_from_string(name)) continue;
    std::string all;
    for (const QuadricType type : all_quadric_types()) {
      if (!is_imaginary(type)) all += (all.empty() ? "" : ", ") + std::string(to_string(type));
    }
    return "unknown type '" + name + "'; the types are " + all;
  }
  return count > 0 ? "" : "names no type";
}

}  // namespace

void DetectorArguments::add_to(CLI::App& command) {
  command.add_option("--config", config, "Settings of the detector (TOML)")->type_name("FILE");
  command.add_option("--only", only, "Report only these types, separated by commas")
      ->type_name("TYPE,...")
      ->check(CLI::Validator(check_types, ""));
  command.add_option("--seed", seed, "Chooses the random stream")->type_name("N");
  command.add_option("--threads", threads, "Threads to use; never changes the result")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
}

DetectorOptions DetectorArguments::options() const {
  DetectorOptions options = config.empty() ? DetectorOptions() : io::load_detector_options(config);
  if (seed) options.seed = *seed;
  if (threads) options.threads = *threads;
  if (!only.empty()) options.only = types_of(only);
  return options;
}

}  // namespace quadrille

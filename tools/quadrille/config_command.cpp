#include "quadrille/config_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/types_option.hpp"
#include "io/planner/config.hpp"

namespace quadrille {
namespace {

struct ConfigArguments {
  std::string config;
  std::vector<QuadricType> only;
  bool defaults = false;
};

void run(const ConfigArguments& arguments) {
  io::Config config = arguments.defaults ? io::Config() : io::load_config(arguments.config);
  if (!arguments.only.empty()) config.detector.only = arguments.only;
  if (!arguments.only.empty()) config.detector = io::search_options(config);
  print(io::to_toml(config));
}

}  // namespace

void add_config_command(CLI::App& app) {
  auto arguments = std::make_shared<ConfigArguments>();
  CLI::App* command = app.add_subcommand(
      "config", "Print the settings as TOML, with units, ranges, defaults and meanings");
  CLI::Option* const config =
      command->add_option("--config", arguments->config, "Settings (TOML)")->type_name("FILE");
  add_types_option(*command, "--only", arguments->only,
                   "Print those with which `quadrille detect` finds only these types");
  command->add_flag("--defaults", arguments->defaults, "Print those without any file")
      ->excludes(config);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille

#include "quadrille/config_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/output.hpp"
#include "io/planner/config.hpp"

namespace quadrille {
namespace {

struct ConfigArguments {
  std::string config;
  bool defaults = false;
};

void run(const ConfigArguments& arguments) {
  print(io::to_toml(arguments.defaults ? io::Config() : io::load_config(arguments.config)));
}

}  // namespace

void add_config_command(CLI::App& app) {
  auto arguments = std::make_shared<ConfigArguments>();
  CLI::App* command = app.add_subcommand(
      "config", "Print the settings as TOML, with units, ranges, defaults and meanings");
  CLI::Option* const config =
      command->add_option("--config", arguments->config, "Settings (TOML)")->type_name("FILE");
  command->add_flag("--defaults", arguments->defaults, "Print those without any file")
      ->excludes(config);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille

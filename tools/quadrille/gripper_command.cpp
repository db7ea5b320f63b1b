#include "quadrille/gripper_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>
#include <string>

#include "cli/output.hpp"
#include "io/planner/gripper_file.hpp"

namespace quadrille {
namespace {

std::string list_grippers() {
  std::string text;
  for (const std::string& name : io::gripper_names()) {
    const Gripper hand = io::load_gripper(name);
    text += fmt::format("{:<14} opens {:g} to {:g} mm, closes with up to {:g} N\n", name,
                        1000.0 * hand.min_opening, 1000.0 * hand.max_opening, hand.max_force);
  }
  return text;
}

void run(const std::string& name) {
  if (name.empty()) return print(list_grippers());
  try {
    print(io::gripper_toml(name));
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("NAME", error.what());
  }
}

}  // namespace

void add_gripper_command(CLI::App& app) {
  auto name = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "gripper",
      "Print a built-in hand as TOML, which --gripper FILE reads; without NAME list all");
  command->add_option("NAME", *name, "A built-in hand, such as franka");
  command->callback([name] { run(*name); });
}

}  // namespace quadrille

#include "cli/planner_arguments.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "cli/choice_option.hpp"
#include "io/gripper_file.hpp"
#include "io/unknown_policy.hpp"

namespace quadrille {

void PlannerArguments::add_to(CLI::App& app, const std::string& default_gripper) {
  gripper_name = default_gripper;
  auto* gripper = app.add_option("--gripper", gripper_name, "Built-in name, or a TOML file")
                      ->type_name("NAME|FILE");
  if (default_gripper.empty()) {
    gripper->required();
  } else {
    gripper->capture_default_str();
  }
  Choices<UnknownPolicy> policies;
  for (const UnknownPolicy policy : io::all_unknown_policies()) {
    policies.emplace_back(io::to_string(policy), policy);
  }
  add_choice_option(app, "--unknown", unknown, policies, "What unobserved space counts as");
}

Gripper PlannerArguments::gripper() const {
  try {
    return io::load_gripper(gripper_name);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--gripper", std::string(error.what()) + ", or a .toml file");
  }
}

}  // namespace quadrille

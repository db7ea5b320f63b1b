#include "cli/planner/planner_arguments.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "cli/choice_option.hpp"
#include "io/planner/gripper_file.hpp"

namespace quadrille {

namespace {

// CLI::Range accepts NaN.
bool is_between_0_and(double most, const std::string& text) {
  double value = 0.0;
  return CLI::detail::lexical_cast(text, value) && value >= 0.0 && value <= most;
}

std::string check_deadline(const std::string& text) {
  return is_between_0_and(PlanOptions::kMaxDeadline, text) ? "" : "must be 0 to 3600000 ms";
}

std::string check_score(const std::string& text) {
  return is_between_0_and(1.0, text) ? "" : "must be 0 to 1";
}

}  // namespace

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
  for (const auto& [word, policy] : words_of(UnknownPolicy{})) policies.emplace_back(word, policy);
  add_choice_option(app, "--unknown", unknown, policies, "What unobserved space counts as");
  app.add_option("--min-score", min_score, "Least probability of a grasp to succeed")
      ->check(check_score)
      ->type_name("P");
  app.add_option("--deadline-ms", deadline_ms,
                 "End a plan after so long with the grasps that it has, and say so; 0: never")
      ->check(check_deadline)
      ->type_name("T");
}

PlanOptions PlannerArguments::overrule(PlanOptions file) const {
  file.unknown = unknown.value_or(file.unknown);
  file.min_score = min_score.value_or(file.min_score);
  file.deadline_ms = deadline_ms.value_or(file.deadline_ms);
  return file;
}

Gripper PlannerArguments::gripper() const {
  try {
    return io::load_gripper(gripper_name);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--gripper", std::string(error.what()) + ", or a .toml file");
  }
}

}  // namespace quadrille

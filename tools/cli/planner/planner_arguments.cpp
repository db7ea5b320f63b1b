#include "cli/planner/planner_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/choice_option.hpp"
#include "cli/number_list.hpp"
#include "io/planner/gripper_file.hpp"
#include "quadrille/detector/printable.hpp"

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

ReachOptions reach_of(const std::string& list) {
  const std::vector<double> v = numbers_of("--reach", list, 5, "X,Y,Z,MIN,MAX");
  constexpr double kMax = ReachOptions::kMaxReach, kMaxPlace = ReachOptions::kMaxPlace;
  const auto refuse = [&](const std::string& rule) {
    throw CLI::ValidationError("--reach", fmt::format("'{}': {}", printable(list), rule));
  };
  if (!(std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}) <= kMaxPlace)) {
    refuse(fmt::format("X, Y and Z must lie between -{0:g} and {0:g} m", kMaxPlace));
  }
  if (!(v[3] >= 0.0 && v[3] <= v[4] && v[4] > 0.0 && v[4] <= kMax)) {
    refuse(fmt::format("MAX must be more than 0 and at most {:g} m, MIN 0 to MAX", kMax));
  }
  return {{v[0], v[1], v[2]}, v[3], v[4]};
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
  app.add_option_function<std::string>(
         "--reach", [this](const std::string& list) { reach = reach_of(list); },
         "Grasp only where the middle between the pads is this far from the arm's base at X,Y,Z, "
         "also before the approach [m]")
      ->type_name("X,Y,Z,MIN,MAX");
  app.add_option("--min-score", min_score, "Least probability of a grasp to succeed")
      ->check(check_score)
      ->type_name("P");
  app.add_option("--per-target", per_target,
                 "Seek so many unlike grasps of each target, and give no more; 0: a dozen or so")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()))
      ->type_name("N");
  app.add_option("--deadline-ms", deadline_ms,
                 "End a plan after so long with the grasps that it has, and say so; 0: never")
      ->check(check_deadline)
      ->type_name("T");
}

PlanOptions PlannerArguments::overrule(PlanOptions file, std::optional<int> threads) const {
  file.unknown = unknown.value_or(file.unknown);
  file.min_score = min_score.value_or(file.min_score);
  file.per_target = per_target.value_or(file.per_target);
  file.reach = reach.value_or(file.reach);
  file.threads = threads.value_or(file.threads);
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

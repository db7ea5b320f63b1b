#pragma once

#include <optional>
#include <string>

#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan_options.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The planner's options on the command line, shared by the programs that plan.
struct PlannerArguments {
  std::string gripper_name;
  std::optional<UnknownPolicy> unknown;
  std::optional<double> deadline_ms, min_score;
  std::optional<int> per_target;
  std::optional<ReachOptions> reach;

  /// Adds --gripper, --unknown, --reach, --min-score, --per-target and --deadline-ms; this object
  /// must outlive the app.
  /// @param default_gripper  if empty, --gripper is required
  void add_to(CLI::App& app, const std::string& default_gripper);
  /// Returns the settings of the file, overridden by those of the command line.
  /// @param threads  of --threads, which holds for detector and planner alike
  PlanOptions overrule(PlanOptions file, std::optional<int> threads = std::nullopt) const;
  /// Returns the gripper that is named.
  /// @throws CLI::ValidationError if there is none of that name
  /// @throws io::FileError if its file is wrong
  Gripper gripper() const;
};

}  // namespace quadrille

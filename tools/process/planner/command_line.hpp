#pragma once

#include <string>
#include <vector>

#include "cli/frame_arguments.hpp"
#include "cli/planner/planner_arguments.hpp"
#include "process/planner/settings.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The command line options of the process.
class PlannerCommandLine {
 public:
  /// Adds the options to an app, which must not outlive this object.
  explicit PlannerCommandLine(CLI::App& app);

  /// Returns the settings, once the app has parsed the options.
  /// @throws CLI::ValidationError if there is no such gripper
  /// @throws io::FileError if the configuration or the gripper's file is wrong
  PlannerSettings settings() const;

 private:
  PlannerSettings settings_;
  PlannerArguments planner_;
  CameraPoseArgument camera_;
  std::vector<QuadricType> report_;
  std::string config_;
};

}  // namespace quadrille

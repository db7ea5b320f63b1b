#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/frame_arguments.hpp"
#include "cli/planner/planner_arguments.hpp"
#include "lab/scene/family.hpp"
#include "lab/study/run_study.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The command line of `study grasps`.
struct StudyArguments {
  std::vector<std::string> inputs;
  int scenes = 0, threads = 0;
  std::uint64_t seed = 0;
  scene::Family family = scene::Family::kTabletop;
  std::string csv, config, report;
  /// Shard in the form I/N.
  std::string shard = "1/1";
  study::Tries tries = study::Tries::kFirst;
  physics::TrialOptions trial;
  PlannerArguments planner;
  FrameArguments frames;

  /// Adds the options to the command; this object must outlive the command.
  void add_to(CLI::App& command);

  /// Returns the options with which each scene is processed.
  study::StudyOptions options() const;
  /// Returns the same options as TOML.
  static std::string settings(const study::StudyOptions& options);
  /// Returns the label of the options that every row carries.
  study::Label label(const study::StudyOptions& options) const;
  /// Returns the scenes that belong to this run's shard.
  std::vector<study::SceneName> chosen(const std::vector<study::SceneName>& all) const;
};

}  // namespace quadrille

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
  /// I/N.
  std::string shard = "1/1";
  study::Tries tries = study::Tries::kFirst;
  physics::TrialOptions trial;
  PlannerArguments planner;
  FrameArguments frames;

  /// Adds the options; this must outlive the command.
  void add_to(CLI::App& command);

  /// With what each scene is worked on.
  study::StudyOptions options() const;
  /// The same as TOML.
  static std::string settings(const study::StudyOptions& options);
  /// What every row says of them.
  study::Label label(const study::StudyOptions& options) const;
  /// Which scenes of all are this run's.
  std::vector<study::SceneName> chosen(const std::vector<study::SceneName>& all) const;
};

}  // namespace quadrille

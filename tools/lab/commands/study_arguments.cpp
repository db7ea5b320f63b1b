#include "lab/commands/study_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <thread>
#include <utility>

#include "cli/choice_option.hpp"
#include "cli/report_option.hpp"
#include "cli/seed_option.hpp"
#include "io/planner/config.hpp"

namespace quadrille {
namespace {

/// Parses I and N of "I/N"; returns 0 and 0 if the text is not a shard.
std::pair<int, int> shard_of_text(const std::string& text) {
  int shard = 0, shards = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '/') return {0, 0};
  const auto second = std::from_chars(first.ptr + 1, end, shards);
  if (second.ec != std::errc{} || second.ptr != end) return {0, 0};
  return shard >= 1 && shard <= shards ? std::pair(shard, shards) : std::pair(0, 0);
}

std::string check_shard(const std::string& text) {
  if (shard_of_text(text).first > 0) return "";
  return "'" + text + "' is no shard I/N with I from 1 to N, such as 2/8";
}

std::string check_csv(const std::string& path) {
  if (path.ends_with(".csv") && !path.ends_with(".scenes.csv")) return "";
  return "'" + path + "' must end in .csv, and not in .scenes.csv";
}

/// Returns the hand's sizes, which its name does not determine if it comes from a file.
std::string sizes_of(const Gripper& g) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", g.max_opening, g.min_opening,
                     g.finger.x(), g.finger.y(), g.finger.z(), g.finger_front, g.pad.x(), g.pad.y(),
                     g.palm.x(), g.palm.y(), g.palm.z(), g.max_force, g.link_length, g.link_angle,
                     g.tcp);
}

/// Describes the frames in which clouds are interpreted.
std::string text_of(const FrameArguments& frames) {
  std::string text;
  const Eigen::Matrix4d X = frames.working_frame().matrix();
  for (int i = 0; i < 16; ++i) text += fmt::format("{} ", X(i));
  if (!frames.viewpoint) return text;
  const Eigen::Vector3d& p = *frames.viewpoint;
  return text + fmt::format("viewpoint {} {} {}", p.x(), p.y(), p.z());
}

void add_trial_options(CLI::App& command, StudyArguments* arguments) {
  add_choice_option(command, "--try", arguments->tries,
                    Choices<study::Tries>{{"none", study::Tries::kNone},
                                          {"first", study::Tries::kFirst},
                                          {"all", study::Tries::kAll}},
                    "Grasps to try in Bullet: none, the best of each target (default), or all");
  command.add_option("--friction", arguments->trial.friction, "Of pads and objects")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command.add_option("--density", arguments->trial.density, "Of objects [kg/m3]")
      ->check(CLI::Range(1.0, 30000.0))
      ->capture_default_str();
  command.add_option("--force", arguments->trial.force, "Closing force [N]; 0: the gripper's own")
      ->check(CLI::Range(0.0, 10000.0));
}

void add_scene_options(CLI::App& command, StudyArguments* arguments) {
  Choices<scene::Family> families;
  for (const scene::Family family : {scene::Family::kEasy, scene::Family::kMedium,
                                     scene::Family::kHard, scene::Family::kTabletop}) {
    families.emplace_back(scene::traits_of(family).name, family);
  }
  CLI::Option* const inputs = command.add_option(
      "INPUT", arguments->inputs, "Clouds, LCM logs and folders of them, instead of new scenes");
  command.add_option("--scenes", arguments->scenes, "Scenes to make")
      ->check(CLI::Range(1, 10000000))
      ->excludes(inputs);
  add_choice_option(command, "--family", arguments->family, families,
                    "How hard the scenes are (default: tabletop)")
      ->excludes(inputs);
  add_seed_option(command, arguments->seed, "the first scene; the next ones follow")
      ->excludes(inputs);
}

}  // namespace

void StudyArguments::add_to(CLI::App& command) {
  add_scene_options(command, this);
  planner.add_to(command, "");
  command.add_option("--csv", csv, "Table of grasps to write, or to go on with")
      ->required()
      ->type_name("FILE.csv")
      ->check(CLI::Validator(check_csv, ""));
  command.add_option("--config", config, "Settings (TOML)")->type_name("FILE");
  command.add_option("--threads", threads, "Scenes at a time (default: one a core)")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  command.add_option("--shard", shard, "Only every N-th scene, from the I-th on")
      ->type_name("I/N")
      ->check(CLI::Validator(check_shard, ""));
  add_trial_options(command, this);
  add_report_option(command, report, "the shares, and the first clouds with their grasps");
  frames.add_to(command);
}

study::StudyOptions StudyArguments::options() const {
  const io::Config file = io::load_config(config);
  study::StudyOptions options{planner.gripper(), file.detector, planner.overrule(file.planner),
                              trial, tries};
  if (options.gripper.name.empty()) options.gripper.name = planner.gripper_name;
  // The planner needs detections of all types, so --only limits the report instead of the search.
  if (options.detector.report.empty()) options.detector.report = options.detector.only;
  options.detector.only.clear();
  // Threads are used across scenes, so each detector and each planner gets one.
  options.detector.threads = 1;
  options.plan.threads = 1;
  return options;
}

std::string StudyArguments::settings(const study::StudyOptions& options) {
  io::Config config;
  config.detector = options.detector;
  config.planner = options.plan;
  return io::to_toml(config);
}

study::Label StudyArguments::label(const study::StudyOptions& options) const {
  const std::string family = inputs.empty() ? scene::traits_of(this->family).name : "";
  return study::label_of(options, QUADRILLE_VERSION, family,
                         settings(options) + sizes_of(options.gripper) + text_of(frames));
}

std::vector<study::SceneName> StudyArguments::chosen(
    const std::vector<study::SceneName>& all) const {
  const auto [number, count] = shard_of_text(shard);
  return study::shard_of(all, number, count);
}

}  // namespace quadrille

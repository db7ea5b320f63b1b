#include "lab/commands/study_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "lab/commands/output_folder.hpp"
#include "lab/commands/study_arguments.hpp"
#include "lab/commands/study_clouds.hpp"
#include "lab/commands/study_report.hpp"
#include "lab/scene/scene.hpp"
#include "lab/scene/scene_files.hpp"
#include "lab/study/run_study.hpp"
#include "lab/study/summary.hpp"

namespace quadrille {
namespace {

struct SummaryArguments {
  std::vector<std::string> tables;
  std::string plot;
};

std::vector<study::SceneName> generated_names(const StudyArguments& arguments) {
  std::vector<study::SceneName> names;
  for (int k = 0; k < arguments.scenes; ++k) {
    const std::string seed = std::to_string(arguments.seed + static_cast<std::uint64_t>(k));
    names.push_back(
        {k + 1, fmt::format("{} {}", scene::traits_of(arguments.family).name, seed), seed});
  }
  return names;
}

study::StudyInput generated(scene::Family family, const study::SceneName& name) {
  scene::SceneOptions options;
  options.family = family;
  options.seed = std::stoull(name.seed);
  const scene::Scene made = scene::make_scene(options);
  study::StudyInput input;
  input.cloud.points = made.view.points;
  input.cloud.frame = "camera";
  input.cloud.read = made.view.points.size();
  input.truth = physics::true_scene(scene::truth_json(made));
  return input;
}

/// Makes a study of the chosen scenes; each scene is made or read when its turn comes.
study::Study study_of(const StudyArguments& arguments) {
  study::Study study;
  study.options = arguments.options();
  study.label = arguments.label(study.options);
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  study.threads = arguments.threads > 0 ? arguments.threads : cores;
  if (arguments.inputs.empty()) {
    study.names = arguments.chosen(generated_names(arguments));
    study.input = [family = arguments.family, names = study.names](std::size_t index) {
      return generated(family, names[index]);
    };
    return study;
  }
  const std::vector<StudyCloud> all = list_clouds(arguments.inputs);
  std::vector<study::SceneName> names;
  for (const StudyCloud& cloud : all) {
    names.push_back({static_cast<int>(names.size()) + 1, cloud.name, ""});
  }
  study.names = arguments.chosen(names);
  std::vector<StudyCloud> clouds;
  for (const study::SceneName& name : study.names) {
    clouds.push_back(all[static_cast<std::size_t>(name.number - 1)]);
  }
  const auto reader = std::make_shared<StudyCloudReader>(clouds, arguments.frames);
  study.input = [reader, clouds](std::size_t index) { return reader->read(clouds[index]); };
  return study;
}

void check_usage(const StudyArguments& arguments) {
  if (arguments.inputs.empty() && arguments.scenes == 0) {
    throw CLI::ValidationError("study grasps", "give --scenes N, or clouds to plan on");
  }
  const bool has_frames = arguments.frames.viewpoint || arguments.frames.camera.X_WK;
  if (arguments.inputs.empty() && has_frames) {
    throw CLI::ValidationError("--viewpoint", "is for given clouds; scenes have a camera");
  }
}

int failed_of(const std::vector<study::GroupSummary>& groups) {
  int failed = 0;
  for (const study::GroupSummary& group : groups) failed += group.failed;
  return failed;
}

void run(const StudyArguments& arguments) {
  check_usage(arguments);
  study::Study study = study_of(arguments);
  if (const std::string missing = physics::missing_physics();
      !missing.empty() && study.options.tries != study::Tries::kNone) {
    throw std::runtime_error(missing + "; or give --try none");
  }
  {
    study::StudyFiles files(arguments.csv, study.label, study.names);
    if (files.finished() > 0) {
      fmt::print(stderr, "quadrille: {}: {} of {} scenes are there already\n", arguments.csv,
                 files.finished(), study.names.size());
    }
    ProgressLine line;
    study.progress = [&](double share) { line.show(share); };
    study::run_study(study, &files);
  }
  const std::vector<study::GroupSummary> groups = study::summarise({arguments.csv});
  print(study::summary_text(groups));
  const std::string plot =
      draw_plots(std::filesystem::path(arguments.csv).replace_extension(".svg").string(),
                 study::score_plots(groups));
  if (!arguments.report.empty()) {
    // The study is made anew because the clouds of a log can be read only once.
    write_study_report(arguments.report, study_of(arguments), groups,
                       StudyArguments::settings(study.options));
  }
  print(fmt::format("{}, {}, {}\n", arguments.csv, study::scenes_path(arguments.csv), plot));
  if (const int failed = failed_of(groups); failed > 0) {
    throw std::runtime_error(
        fmt::format("{} of {} clouds could not be used; {} says why, in the "
                    "column error",
                    failed, study.names.size(), study::scenes_path(arguments.csv)));
  }
}

void add_summary_command(CLI::App& study) {
  auto arguments = std::make_shared<SummaryArguments>();
  CLI::App* command = study.add_subcommand("summary", "Sum up the tables of studies");
  command->add_option("CSV", arguments->tables, "Tables of study grasps, such as those of shards")
      ->required();
  command->add_option("--plot", arguments->plot, "Draw the shares over the score")
      ->type_name("FILE.svg");
  command->callback([arguments] {
    const std::vector<study::GroupSummary> groups = study::summarise(arguments->tables);
    print(study::summary_text(groups));
    if (!arguments->plot.empty()) draw_plots(arguments->plot, study::score_plots(groups));
  });
}

}  // namespace

void add_study_command(CLI::App& app) {
  CLI::App* study = app.add_subcommand(
      "study", "Plan, judge and try grasps over many scenes; sum up what came out");
  study->require_subcommand(1);
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = study->add_subcommand(
      "grasps", "Find, plan, judge and try grasps: one row a grasp, and one a scene");
  arguments->add_to(*command);
  command->callback([arguments] { run(*arguments); });
  add_summary_command(*study);
}

}  // namespace quadrille

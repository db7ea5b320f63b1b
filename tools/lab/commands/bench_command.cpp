#include "lab/commands/bench_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "cli/seed_option.hpp"
#include "io/settings/config.hpp"
#include "lab/bench/bench.hpp"
#include "lab/bench/report.hpp"
#include "lab/bench/stability.hpp"
#include "lab/bench/stages.hpp"
#include "lab/commands/bench_speed.hpp"
#include "lab/commands/output_folder.hpp"

namespace quadrille {
namespace {

namespace fs = std::filesystem;

struct BenchArguments {
  std::vector<std::string> families = {"easy", "medium", "hard"}, contenders;
  std::string out = ".", config;
  bool list = false, stages = false, stability = false, speed = false;
  bench::FrameOptions frames;
  SpeedFiles speed_files;
};

const std::map<std::string, scene::Family>& families() {
  static const std::map<std::string, scene::Family> all = {{"easy", scene::Family::kEasy},
                                                           {"medium", scene::Family::kMedium},
                                                           {"hard", scene::Family::kHard},
                                                           {"tabletop", scene::Family::kTabletop},
                                                           {"bin", scene::Family::kBin}};
  return all;
}

/// The folder of this program, in which the others lie that it runs.
std::string programs() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  return error ? "." : self.parent_path().string();
}

std::vector<bench::Contender> all_contenders(const io::DetectorConfig& config = {}) {
  return bench::all_contenders(programs(), config);
}

/// Reads the detector's settings.
/// @throws io::FileError also if they choose types
io::DetectorConfig settings_of(const std::string& path) {
  io::DetectorConfig config = io::load_detector_config(path);
  io::refuse_choice_of_types(config.given, path);
  // No contender uses more.
  config.detector.threads = 1;
  return config;
}

std::vector<bench::Contender> chosen(const std::vector<std::string>& names,
                                     const io::DetectorConfig& config) {
  std::vector<bench::Contender> contenders = all_contenders(config);
  if (names.empty()) return contenders;
  std::erase_if(contenders, [&](const bench::Contender& contender) {
    return std::find(names.begin(), names.end(), contender.name) == names.end();
  });
  return contenders;
}

std::string command_of(const BenchArguments& arguments) {
  std::string command = "quadrille bench";
  for (const std::string& cloud : arguments.frames.clouds) command += " " + cloud;
  if (arguments.frames.clouds.empty()) {
    command += fmt::format(" --family {} --scenes {} --seed {}", fmt::join(arguments.families, ","),
                           arguments.frames.scenes, arguments.frames.seed);
  }
  if (!arguments.contenders.empty()) {
    command += fmt::format(" --contender {}", fmt::join(arguments.contenders, ","));
  }
  if (!arguments.config.empty()) command += " --config " + arguments.config;
  return command;
}

void list_contenders() {
  for (const bench::Contender& contender : all_contenders()) {
    print(fmt::format("{:<21} {}{}\n", contender.name, contender.about,
                      contender.absent.empty() ? "" : " (" + contender.absent + ")"));
  }
}

void print_stages(const bench::FrameOptions& frames, const DetectorOptions& options) {
  std::vector<bench::StageCounts> families;
  {
    ProgressLine line;
    bench::FrameOptions shown = frames;
    shown.progress = [&](double share) { line.show(share); };
    families = bench::count_stages(shown, options);
  }
  print(to_markdown(bench::to_table(families)));
}

void print_stability(const std::vector<std::string>& clouds, const DetectorOptions& options) {
  std::vector<bench::Stability> list;
  {
    ProgressLine line;
    list = bench::measure_stability(clouds, options, [&](double share) { line.show(share); });
  }
  print(to_markdown(bench::to_table(list)));
}

void compare(BenchArguments arguments, const io::DetectorConfig& config) {
  const std::vector<bench::Contender> contenders = chosen(arguments.contenders, config);
  for (const bench::Contender& contender : contenders) {
    if (contender.absent.empty()) continue;
    print_warnings("bench", {"without " + contender.name + ": " + contender.absent});
  }
  OutputFolder files(arguments.out, {"bench.md", "bench.csv", "bench.json", "bench.svg"});
  std::vector<bench::Row> rows;
  {
    ProgressLine line;
    arguments.frames.progress = [&](double share) { line.show(share); };
    rows = bench::run_bench(contenders, arguments.frames);
  }
  files.write("bench.md",
              bench::to_markdown(rows, contenders, command_of(arguments), QUADRILLE_VERSION));
  files.write("bench.csv", experiments::to_csv(bench::to_table(rows)));
  files.write("bench.json", bench::to_json(rows).dump(1) + "\n");
  files.draw("bench.svg", bench::plots_of(rows));
  print(to_markdown(bench::to_table(rows)));
  print(files.list() + "\n");
}

/// Adds what --speed needs.
void add_speed_options(CLI::App& command, const std::shared_ptr<BenchArguments>& arguments,
                       const std::vector<CLI::Option*>& others) {
  CLI::Option* const speed = command.add_flag(
      "--speed", arguments->speed,
      "Only print the time and the instructions of each stage, beside a baseline; fail if all "
      "together take 3 % more instructions. CLOUD needs no truth; without it 4 medium scenes, or "
      "those of --family and --scenes");
  for (CLI::Option* const other : others) speed->excludes(other);
  command
      .add_option("--baseline", arguments->speed_files.baseline,
                  "Instructions to compare with, as --store writes them (default: those that came "
                  "with the program)")
      ->type_name("FILE")
      ->needs(speed);
  command
      .add_option("--store", arguments->speed_files.store,
                  "Store the instructions as the next baseline, and do not fail")
      ->type_name("FILE")
      ->needs(speed);
}

void run(BenchArguments arguments) {
  if (arguments.list) return list_contenders();
  arguments.frames.families.clear();
  for (const std::string& name : arguments.families) {
    arguments.frames.families.push_back(families().at(name));
  }
  const io::DetectorConfig config = settings_of(arguments.config);
  if (arguments.stability) return print_stability(arguments.frames.clouds, config.detector);
  if (arguments.stages) return print_stages(arguments.frames, config.detector);
  if (arguments.speed) {
    return run_speed({arguments.frames, config, arguments.config, programs()},
                     arguments.speed_files);
  }
  compare(std::move(arguments), config);
}

std::string check_contender(const std::string& name) {
  std::string names;
  for (const bench::Contender& contender : all_contenders()) {
    if (contender.name == name) return "";
    names += (names.empty() ? "" : ", ") + contender.name;
  }
  return "'" + name + "' is none of: " + names;
}

}  // namespace

void add_bench_command(CLI::App& app) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* command =
      app.add_subcommand("bench", "Compare the detector with its variants, baselines and peers");
  CLI::Option* const clouds = command->add_option(
      "CLOUD", arguments->frames.clouds,
      "Clouds with their truth, as of quadrille scene --labels, instead of new scenes");
  CLI::Option* const family =
      command->add_option("--family", arguments->families, "Families of scenes")
          ->delimiter(',')
          ->check(CLI::IsMember(families()))
          ->type_name("NAME,...")
          ->excludes(clouds);
  CLI::Option* const scenes =
      command->add_option("--scenes", arguments->frames.scenes, "Scenes of each family")
          ->check(CLI::Range(1, 100000))
          ->capture_default_str()
          ->excludes(clouds);
  add_seed_option(*command, arguments->frames.seed, "the first scene of each family")
      ->excludes(clouds);
  CLI::Option* const contenders =
      command->add_option("--contender", arguments->contenders, "Only these; see --list")
          ->delimiter(',')
          ->check(CLI::Validator(check_contender, ""))
          ->type_name("NAME,...");
  command
      ->add_option("--config", arguments->config,
                   "Settings of the detector and its variants (TOML)")
      ->type_name("FILE");
  CLI::Option* const list =
      command->add_flag("--list", arguments->list, "Only list the contenders");
  CLI::Option* const out =
      command->add_option("--out", arguments->out, "Folder for bench.md, .csv, .json and .svg")
          ->type_name("FOLDER");
  CLI::Option* const stages =
      command
          ->add_flag("--stages", arguments->stages,
                     "Only print at which stage the detector loses surfaces")
          ->excludes(contenders)
          ->excludes(list)
          ->excludes(out);
  CLI::Option* const stability =
      command
          ->add_flag("--stability", arguments->stability,
                     "Only print which curved surfaces of each CLOUD, which needs no truth, the "
                     "detector finds with each of 8 seeds and of 8 shifts by pixels")
          ->needs(clouds)
          ->excludes(contenders)
          ->excludes(list)
          ->excludes(out)
          ->excludes(stages);
  add_speed_options(*command, arguments, {contenders, list, out, stages, stability});
  command->callback([arguments, family, scenes] {
    if (arguments->speed && family->empty()) arguments->families = {"medium"};
    if (arguments->speed && scenes->empty()) arguments->frames.scenes = 4;
    run(*arguments);
  });
}

}  // namespace quadrille

#include "quadrille/experiment_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "experiments/experiment.hpp"
#include "io/file_bytes.hpp"
#include "quadrille/output.hpp"
#include "quadrille/progress_line.hpp"

namespace quadrille {
namespace {

namespace fs = std::filesystem;

struct ExperimentArguments {
  std::string name, out = ".";
  experiments::Settings settings;
};

void list_experiments() {
  for (const auto& experiment : experiments::all_experiments()) {
    print(fmt::format("{:<10} {}\n", experiment.name, experiment.about));
  }
}

void run(ExperimentArguments arguments) {
  if (arguments.name.empty()) return list_experiments();
  const experiments::Experiment& experiment = *experiments::find_experiment(arguments.name);
  fs::create_directories(arguments.out);
  experiments::Report report;
  {
    ProgressLine line;
    arguments.settings.progress = [&](double share) { line.show(share); };
    report = experiment.run(arguments.settings);
  }
  const std::string path = (fs::path(arguments.out) / arguments.name).string();
  io::write_file(path + ".md", experiments::to_markdown(report, experiment, arguments.settings,
                                                        QUADRILLE_VERSION));
  io::write_file(path + ".csv", experiments::to_csv(report.data));
  io::write_file(path + ".svg", experiments::to_svg(report.plots));
  for (const std::string& finding : report.findings) print(finding + "\n");
  print(fmt::format("{0}.md, {0}.csv, {0}.svg\n", path));
}

std::string check_name(const std::string& name) {
  if (experiments::find_experiment(name)) return "";
  std::string names;
  for (const auto& experiment : experiments::all_experiments()) {
    names += (names.empty() ? "" : ", ") + std::string(experiment.name);
  }
  return "'" + name + "' is none of: " + names;
}

}  // namespace

void add_experiment_command(CLI::App& app) {
  auto arguments = std::make_shared<ExperimentArguments>();
  CLI::App* command =
      app.add_subcommand("experiment", "Repeat an experiment of the paper; without NAME list them");
  command->add_option("NAME", arguments->name, "Which one")->check(CLI::Validator(check_name, ""));
  command->add_option("--out", arguments->out, "Folder for NAME.md, NAME.csv and NAME.svg")
      ->type_name("FOLDER");
  command->add_option("--seed", arguments->settings.seed, "Chooses the random numbers")
      ->type_name("N");
  command->add_flag("--quick", arguments->settings.quick, "Little work, to see that it runs");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille

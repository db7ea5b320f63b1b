#include "lab/commands/experiment_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "cli/seed_option.hpp"
#include "lab/commands/output_folder.hpp"
#include "lab/experiments/experiment.hpp"

namespace quadrille {
namespace {

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
  const std::string name = arguments.name;
  const OutputFolder files(arguments.out, {name + ".md", name + ".csv", name + ".svg"});
  experiments::Report report;
  {
    ProgressLine line;
    arguments.settings.progress = [&](double share) { line.show(share); };
    report = experiment.run(arguments.settings);
  }
  files.write(name + ".md",
              experiments::to_markdown(report, experiment, arguments.settings, QUADRILLE_VERSION));
  files.write(name + ".csv", experiments::to_csv(report.data));
  files.write(name + ".svg", experiments::to_svg(report.plots));
  for (const std::string& finding : report.findings) print(finding + "\n");
  print(files.list() + "\n");
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
  add_seed_option(*command, arguments->settings.seed, "the random numbers");
  command->add_flag("--quick", arguments->settings.quick, "Little work, to see that it runs");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille

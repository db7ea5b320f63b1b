#include "lab/commands/experiment_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "cli/seed_option.hpp"
#include "lab/commands/output_folder.hpp"
#include "lab/experiments/experiment.hpp"

namespace quadrille {
namespace {

constexpr const char* kAll = "all";
constexpr const char* kPrinted = "printed";

struct ExperimentArguments {
  std::string name, out = ".";
  experiments::Settings settings;
};

void list_experiments() {
  for (const auto& experiment : experiments::all_experiments()) {
    print(fmt::format("{:<10} {}\n", experiment.name, experiment.about));
  }
}

/// Returns the experiments that a name selects.
std::vector<const experiments::Experiment*> chosen(const std::string& name) {
  std::vector<const experiments::Experiment*> chosen;
  for (const auto& experiment : experiments::all_experiments()) {
    if (name == kAll || name == experiment.name) chosen.push_back(&experiment);
  }
  // "growth" runs first, because peak memory can be measured only before the process has used more.
  std::stable_partition(chosen.begin(), chosen.end(),
                        [](const auto* experiment) { return experiment->name == "growth"; });
  return chosen;
}

OutputFolder folder_for(const std::string& out,
                        const std::vector<const experiments::Experiment*>& chosen) {
  std::vector<std::string> names;
  for (const auto* experiment : chosen) {
    for (const char* ending : {".md", ".csv", ".svg"}) {
      names.push_back(std::string(experiment->name).append(ending));
    }
  }
  return {out, names};
}

/// Runs experiment `index` of `count`, and writes its files.
void run_one(const experiments::Experiment& experiment, experiments::Settings settings,
             std::size_t index, std::size_t count, OutputFolder* files) {
  const std::string name(experiment.name);
  experiments::Report report;
  {
    ProgressLine line;
    settings.progress = [&](double share) {
      line.show((static_cast<double>(index) + share) / static_cast<double>(count));
    };
    report = experiment.run(settings);
  }
  files->write(name + ".md",
               experiments::to_markdown(report, experiment, settings, QUADRILLE_VERSION));
  files->write(name + ".csv", experiments::to_csv(report.data));
  if (!report.plots.empty()) files->draw(name + ".svg", report.plots);
  if (count > 1) print(name + ":\n");
  for (const std::string& finding : report.findings) print(finding + "\n");
}

void run(const ExperimentArguments& arguments) {
  if (!arguments.settings.config.empty() && arguments.name != kPrinted) {
    throw CLI::ValidationError("--config", std::string("is only for the experiment ") + kPrinted);
  }
  if (arguments.name.empty()) return list_experiments();
  const auto experiments = chosen(arguments.name);
  OutputFolder files = folder_for(arguments.out, experiments);
  for (std::size_t k = 0; k < experiments.size(); ++k) {
    run_one(*experiments[k], arguments.settings, k, experiments.size(), &files);
  }
  print(files.list() + "\n");
}

std::string check_name(const std::string& name) {
  if (!chosen(name).empty()) return "";
  std::string names;
  for (const auto& experiment : experiments::all_experiments()) {
    names += std::string(experiment.name) + ", ";
  }
  return "'" + name + "' is none of: " + names + kAll;
}

}  // namespace

void add_experiment_command(CLI::App& app) {
  auto arguments = std::make_shared<ExperimentArguments>();
  CLI::App* command =
      app.add_subcommand("experiment", "Repeat an experiment of the paper; without NAME list them");
  command->add_option("NAME", arguments->name, "Which one, or all")
      ->check(CLI::Validator(check_name, ""));
  command
      ->add_option("--out", arguments->out,
                   "Folder for NAME.md, NAME.csv and, if it has plots, NAME.gnuplot and NAME.svg")
      ->type_name("FOLDER");
  add_seed_option(*command, arguments->settings.seed, "the random numbers");
  command
      ->add_option("--config", arguments->settings.config,
                   "Settings of the printed pipeline (TOML), for the experiment of that name")
      ->type_name("FILE");
  command->add_flag("--quick", arguments->settings.quick, "Little work, to see that it runs");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille

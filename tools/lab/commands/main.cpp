#include <CLI/CLI.hpp>

#include "cli/run_program.hpp"
#include "lab/commands/bench_command.hpp"
#include "lab/commands/experiment_command.hpp"
#include "lab/commands/study_command.hpp"

int main(int argc, char** argv) {
  // This program implements some commands of `quadrille`, which replaces itself with this program
  // to run them.
  CLI::App app("Repeats the paper's experiments, compares detectors and studies grasps",
               "quadrille");
  app.require_subcommand(1);
  quadrille::add_experiment_command(app);
  quadrille::add_bench_command(app);
  quadrille::add_study_command(app);
  // The commands do their work while they are parsed.
  return quadrille::run_program(app, argc, argv, [] {});
}

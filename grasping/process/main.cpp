#include <CLI/CLI.hpp>

#include "cli/run_program.hpp"
#include "command_line.hpp"
#include "quadrille/bus/stop.hpp"
#include "run.hpp"

int main(int argc, char** argv) {
  CLI::App app("Plans grasps on the quadrics and clouds of LCM channels.",
               "quadrille-grasp-planner");
  const quadrille::CommandLine command_line(app);
  return quadrille::run_program(app, argc, argv, [&] {
    const quadrille::PlannerSettings settings = command_line.settings();
    quadrille::start_logging(app, settings.process.verbose);
    quadrille::bus::install_stop_signals();
    if (settings.process.in_log.empty()) {
      quadrille::run_on_bus(settings);
    } else {
      quadrille::run_on_log(settings);
    }
  });
}

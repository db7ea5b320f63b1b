#include <CLI/CLI.hpp>

#include "cli/run_program.hpp"
#include "process/planner/command_line.hpp"
#include "process/planner/node.hpp"
#include "process/runtime/run.hpp"

int main(int argc, char** argv) {
  CLI::App app("Plans grasps on the quadrics and clouds of LCM channels.",
               "quadrille-grasp-planner");
  const quadrille::PlannerCommandLine command_line(app);
  return quadrille::run_program(app, argc, argv, [&] {
    const quadrille::PlannerSettings settings = command_line.settings();
    quadrille::run_process(app.get_name(), settings.process, [&](quadrille::bus::Publish publish) {
      return std::make_unique<quadrille::PlannerNode>(settings, std::move(publish));
    });
  });
}

#include <CLI/CLI.hpp>

#include "cli/run_program.hpp"
#include "command_line.hpp"
#include "node.hpp"
#include "process/run.hpp"

int main(int argc, char** argv) {
  CLI::App app("Plans grasps on the quadrics and clouds of LCM channels.",
               "quadrille-grasp-planner");
  const quadrille::CommandLine command_line(app);
  return quadrille::run_program(app, argc, argv, [&] {
    const quadrille::PlannerSettings settings = command_line.settings();
    quadrille::run_process(app.get_name(), settings.process, [&](quadrille::bus::Publish publish) {
      return std::make_unique<quadrille::PlannerNode>(settings, std::move(publish));
    });
  });
}

#include <CLI/CLI.hpp>

#include "cli/run_program.hpp"
#include "command_line.hpp"
#include "node.hpp"
#include "process/run.hpp"

int main(int argc, char** argv) {
  CLI::App app("Detects quadrics in the point clouds of an LCM channel.", "quadrille-detector");
  const quadrille::CommandLine command_line(app);
  return quadrille::run_program(app, argc, argv, [&] {
    const quadrille::DetectorSettings settings = command_line.settings();
    quadrille::run_process(app.get_name(), settings.process, [&](quadrille::bus::Publish publish) {
      return std::make_unique<quadrille::DetectorNode>(settings, std::move(publish));
    });
  });
}

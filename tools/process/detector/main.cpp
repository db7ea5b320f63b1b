#include <CLI/CLI.hpp>

#include "cli/run_program.hpp"
#include "process/detector/command_line.hpp"
#include "process/detector/node.hpp"
#include "process/runtime/run.hpp"

int main(int argc, char** argv) {
  CLI::App app("Detects quadrics in the point clouds of an LCM channel.", "quadrille-detector");
  const quadrille::DetectorCommandLine command_line(app);
  return quadrille::run_program(app, argc, argv, [&] {
    const quadrille::DetectorSettings settings = command_line.settings();
    quadrille::run_process(app.get_name(), settings.process, [&](quadrille::bus::Publish publish) {
      return std::make_unique<quadrille::DetectorNode>(settings, std::move(publish));
    });
  });
}

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>

#include "command_line.hpp"
#include "quadrille/bus/stop.hpp"
#include "run.hpp"

int main(int argc, char** argv) {
  try {
    const quadrille::PlannerSettings settings = quadrille::parse_command_line(argc, argv);
    spdlog::set_default_logger(spdlog::stderr_logger_mt("quadrille-grasp-planner"));
    spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %n %l: %v");
    spdlog::set_level(settings.verbose ? spdlog::level::debug : spdlog::level::info);
    quadrille::bus::install_stop_signals();
    if (settings.in_log.empty()) {
      quadrille::run_on_bus(settings);
    } else {
      quadrille::run_on_log(settings);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "quadrille-grasp-planner: %s\n", error.what());
    return 1;
  }
}

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "quadrille/detect_command.hpp"
#include "quadrille/log_command.hpp"
#include "quadrille/plan_command.hpp"
#include "quadrille/scene_command.hpp"

int main(int argc, char** argv) {
  CLI::App app("Finds quadrics in point clouds and plans grasps on them", "quadrille");
  app.require_subcommand(1);
  quadrille::add_detect_command(app);
  quadrille::add_plan_command(app);
  quadrille::add_scene_command(app);
  quadrille::add_log_command(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "quadrille: " << error.what() << "\n";
    return 1;
  }
}

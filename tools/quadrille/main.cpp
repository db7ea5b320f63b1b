#include <CLI/CLI.hpp>
#include <string_view>
#include <vector>

#include "cli/run_program.hpp"
#include "quadrille/config_command.hpp"
#include "quadrille/detect_command.hpp"
#include "quadrille/doctor_command.hpp"
#include "quadrille/gripper_command.hpp"
#include "quadrille/lab_commands.hpp"
#include "quadrille/log_command.hpp"
#include "quadrille/plan_command.hpp"
#include "quadrille/scene_command.hpp"
#include "quadrille/show_command.hpp"
#include "quadrille/spy_command.hpp"
#include "quadrille/try_command.hpp"
#include "quadrille/view_command.hpp"

namespace {

/// Replaces `help` and `help COMMAND` by the options that they stand for.
std::vector<char*> without_help(int argc, char** argv) {
  static char option[] = "--help";
  std::vector<char*> words(argv, argv + argc);
  if (argc > 1 && std::string_view(argv[1]) == "help") {
    words.erase(words.begin() + 1);
    words.push_back(option);
  }
  return words;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<char*> words = without_help(argc, argv);
  argc = static_cast<int>(words.size());
  words.push_back(nullptr);
  argv = words.data();
  if (quadrille::is_lab_command(argc, argv)) return quadrille::run_lab(argv);
  CLI::App app("Finds quadrics in point clouds and plans grasps on them", "quadrille");
  app.require_subcommand(1);
  quadrille::add_detect_command(app);
  quadrille::add_plan_command(app);
  quadrille::add_try_command(app);
  quadrille::add_scene_command(app);
  quadrille::add_log_command(app);
  quadrille::add_doctor_command(app);
  quadrille::add_config_command(app);
  quadrille::add_gripper_command(app);
  quadrille::add_show_command(app);
  quadrille::add_view_command(app);
  quadrille::add_spy_command(app);
  quadrille::add_lab_commands(app);
  // The commands do their work while they are parsed.
  return quadrille::run_program(app, argc, argv, [] {});
}

#include "quadrille/lab_commands.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace quadrille {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 3> kLabCommands = {
    {{"experiment", "Repeat an experiment of the paper; without NAME list them"},
     {"bench", "Compare the detector with its variants, baselines and peers"},
     {"study", "Plan, judge and try grasps over many scenes; sum up what came out"}}};

}  // namespace

void add_lab_commands(CLI::App& app) {
  for (const auto& [name, about] : kLabCommands) app.add_subcommand(name, about);
}

bool is_lab_command(int argc, const char* const* argv) {
  return argc > 1 &&
         std::any_of(kLabCommands.begin(), kLabCommands.end(), [&](const auto& command) {
           return std::string_view(argv[1]) == command.first;
         });
}

int run_lab(char* const* argv) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path lab = self.parent_path() / "quadrille-lab";
  execv(lab.c_str(), argv);
  std::fprintf(stderr, "quadrille: %s is not there; build it with the target quadrille-lab\n",
               lab.c_str());
  return 1;
}

}  // namespace quadrille

#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Names the commands of the laboratory, `experiment` and `bench`, in the list of the commands.
/// They are in a program of their own, quadrille-lab beside this one, so that who detects and plans
/// need not build it.
void add_lab_commands(CLI::App& app);

/// True if the first argument is one of them.
bool is_lab_command(int argc, const char* const* argv);

/// Becomes quadrille-lab, with the same arguments.
/// @return the exit code 1, if that program is not there, after a line on stderr
int run_lab(char* const* argv);

}  // namespace quadrille

#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Lists the commands of the laboratory, `experiment` and `bench`, among the commands. They are in
/// a separate program, quadrille-lab beside this one, so that users who detect and plan need not
/// build it.
void add_lab_commands(CLI::App& app);

/// Returns true if the first argument is one of these commands.
bool is_lab_command(int argc, const char* const* argv);

/// Replaces this process by quadrille-lab, with the same arguments.
/// @return the exit code 1 if that program is missing, after a line on stderr
int run_lab(char* const* argv);

}  // namespace quadrille

#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace quadrille {

/// The body of every main(): adds --version, parses the command line, then does the work.
/// @param app   its name begins the line on stderr that says what failed
/// @param work  called once the command line is parsed; may throw
/// @return the exit code: 0 for success (also for help or version), 1 for failure, 2 for wrong
/// usage
int run_program(CLI::App& app, int argc, const char* const* argv,
                const std::function<void()>& work);

}  // namespace quadrille

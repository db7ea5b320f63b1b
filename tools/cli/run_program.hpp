#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace quadrille {

/// The body of every main: adds --version, reads the command line, then works.
/// @param app   its name begins the line on stderr that says what failed
/// @param work  called once the command line is read; may throw
/// @return the exit code: 0 done (or help or the version was asked for), 1 failed, 2 wrong usage
int run_program(CLI::App& app, int argc, const char* const* argv,
                const std::function<void()>& work);

}  // namespace quadrille

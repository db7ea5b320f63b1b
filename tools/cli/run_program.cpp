#include "cli/run_program.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

namespace quadrille {

int run_program(CLI::App& app, int argc, const char* const* argv,
                const std::function<void()>& work) {
  try {
    app.parse(argc, argv);
    work();
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), error.what());
    return 1;
  }
}

}  // namespace quadrille

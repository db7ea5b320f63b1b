#include "cli/run_program.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

namespace quadrille {
namespace {

/// One line on what is wrong, and where to read on.
std::string describe_usage_error(const CLI::App* app, const CLI::Error& error) {
  std::string what = error.what();
  while (what.ends_with('\n')) what.pop_back();
  return app->get_name() + ": " + what + "; see " + app->get_name() + " --help\n";
}

}  // namespace

int run_program(CLI::App& app, int argc, const char* const* argv,
                const std::function<void()>& work) {
  app.set_version_flag("--version", app.get_name() + " " + QUADRILLE_VERSION,
                       "Print the version and exit");
  app.failure_message(describe_usage_error);
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

#include "cli/run_program.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "cli/describe_program.hpp"
#include "quadrille/detector/printable.hpp"
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace quadrille {
namespace {

/// Returns an error if a program with commands was given none of them; empty otherwise.
std::string find_missing_command(const CLI::App& app) {
  std::string all;
  for (const CLI::App* command : app.get_subcommands({})) {
    all += (all.empty() ? "" : ", ") + command->get_name();
  }
  if (all.empty() || !app.get_subcommands().empty()) return "";
  const std::vector<std::string> words = app.remaining();
  return (words.empty() ? "" : "unknown command '" + printable(words.front()) + "'; ") +
         "give one of the commands " + all;
}

/// Returns one line on what is wrong, and where to find help.
std::string describe_usage_error(const CLI::App* app, const CLI::Error& error) {
  std::string what = error.what(), command = app->get_name();
  if (const std::string missing = find_missing_command(*app); !missing.empty()) what = missing;
  while (what.ends_with('\n')) what.pop_back();
  for (const CLI::App* chosen : app->get_subcommands()) command += " " + chosen->get_name();
  return app->get_name() + ": " + printable(what, kMaxLine) + "; see " + command + " --help\n";
}

/// Keeps freed memory in the process. Stages and clouds follow each other and need as much memory
/// again; returning it and requesting it anew costs a twentieth of a frame's time.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMax = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, kMax);
  mallopt(M_TRIM_THRESHOLD, 16 * kMax);
#endif
}

}  // namespace

int run_program(CLI::App& app, int argc, const char* const* argv,
                const std::function<void()>& work) {
  const std::string version = app.get_name() + " " + QUADRILLE_VERSION;
  app.set_version_flag("--version", version, "Print the version and exit");
  for (CLI::App* command : app.get_subcommands({})) {
    command->set_version_flag("--version", version, "Print the version and exit");
  }
  app.failure_message(describe_usage_error);
  keep_freed_memory();
  try {
    if (const char* how = std::getenv("QUADRILLE_DESCRIBE")) {
      std::fputs(describe_program(app, how, {argv + 1, argv + argc}).c_str(), stdout);
      return 0;
    }
    app.parse(argc, argv);
    work();
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(),
                 printable(error.what(), kMaxLine).c_str());
    return 1;
  }
}

}  // namespace quadrille

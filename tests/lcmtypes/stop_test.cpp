#include "run/stop.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

/// What a call returns in a process of its own: a stop is never taken back. -1 if it was killed.
template <class Call>
int run_apart(const Call& call) {
  const pid_t child = fork();
  if (child == 0) _exit(call());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_CASE("SIGINT and SIGTERM ask for the end instead of killing", "[bus][stop]") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const int seen = run_apart([signal] {
    install_stop_signals();
    const bool before = stop_requested();
    raise(signal);
    return (before ? 1 : 0) + (stop_requested() ? 2 : 0);
  });
  CHECK(seen == 2);
  CHECK_FALSE(stop_requested());
}

TEST_CASE("a process may ask itself for the end", "[bus][stop]") {
  CHECK(run_apart([] {
          request_stop();
          return stop_requested() ? 1 : 0;
        }) == 1);
}

}  // namespace
}  // namespace quadrille::bus

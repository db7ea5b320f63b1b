#include "process/runtime/respawn.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "process/runtime/logging.hpp"

namespace quadrille {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

sigset_t watched_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&set, signal);
  return set;
}

std::string describe_end(int status) {
  if (WIFEXITED(status)) return fmt::format("ended with {}", WEXITSTATUS(status));
  return fmt::format("was killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
}

/// The parent of one child after the other.
class Supervisor {
 public:
  Supervisor() : watched_(watched_signals()) {
    // Ignored, as a parent may have left it, children vanish without a word.
    signal(SIGCHLD, SIG_DFL);
    // Blocked, they wait until they are asked for: none comes between two steps unnoticed.
    pthread_sigmask(SIG_BLOCK, &watched_, &before_);
  }

  /// Returns in the child.
  void run() {
    for (int restarts = 1;; ++restarts) {
      const Clock::time_point start = Clock::now();
      if (make_child()) return;
      const int status = wait_for_child();
      end_if_done(status);
      const milliseconds life = std::chrono::duration_cast<milliseconds>(Clock::now() - start);
      const milliseconds pause = backoff_.next(life);
      log_warning(fmt::format("the process {} after {:.1f} s; restart {} in {} ms",
                              describe_end(status), 1e-3 * static_cast<double>(life.count()),
                              restarts, pause.count()));
      if (stops_within(pause)) std::exit(0);
    }
  }

 private:
  /// True in the child.
  bool make_child() {
    const pid_t parent = getpid();
    child_ = fork();
    if (child_ < 0) {
      throw std::runtime_error(
          fmt::format("--respawn: no process can be made: {}", std::strerror(errno)));
    }
    if (child_ > 0) return false;
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    // The parent may have died before it was asked to tell.
    if (getppid() != parent) _exit(1);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    return true;
  }

  /// Waits for the child's end, passing signals on; its status.
  int wait_for_child() {
    for (;;) {
      int status = 0;
      const pid_t ended = waitpid(child_, &status, WNOHANG);
      if (ended == child_) return status;
      if (ended < 0 && errno != EINTR) return kLost;
      const int signal = sigwaitinfo(&watched_, nullptr);
      if (signal <= 0 || signal == SIGCHLD) continue;
      stopping_ = true;
      kill(child_, signal);
    }
  }

  /// Ends the parent too, if the child is not to be replaced.
  void end_if_done(int status) const {
    constexpr int kWrongUsage = 2;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    const bool is_final = WIFEXITED(status) && (code == 0 || code == kWrongUsage);
    if (stopping_ || is_final) std::exit(code);
  }

  /// Whether a signal asks for the end before the time is over.
  bool stops_within(milliseconds pause) const {
    const Clock::time_point end = Clock::now() + pause;
    for (;;) {
      const auto left = std::max(Clock::duration::zero(), Clock::duration(end - Clock::now()));
      const timespec wait = {std::chrono::duration_cast<std::chrono::seconds>(left).count(),
                             std::chrono::nanoseconds(left).count() % 1'000'000'000};
      const int signal = sigtimedwait(&watched_, nullptr, &wait);
      if (signal > 0 && signal != SIGCHLD) return true;
      if (signal < 0 && errno == EAGAIN) return false;
    }
  }

  /// As of a child that exits with 1: somebody else has asked for its status.
  static constexpr int kLost = 1 << 8;

  sigset_t watched_, before_;
  pid_t child_ = -1;
  bool stopping_ = false;
  Backoff backoff_;
};

}  // namespace

milliseconds Backoff::next(milliseconds life) {
  if (life >= kLongLife) {
    early_deaths_ = 0;
    return milliseconds(0);
  }
  // The first early death may be chance.
  if (++early_deaths_ == 1) return milliseconds(0);
  constexpr int kMaxDoublings = 10;
  return std::min(kMax, kFirst * (1 << std::min(early_deaths_ - 2, kMaxDoublings)));
}

void respawn() { Supervisor().run(); }

}  // namespace quadrille

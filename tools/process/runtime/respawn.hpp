#pragma once

#include <chrono>

namespace quadrille {

/// How long to wait before a process that has died is started anew.
class Backoff {
 public:
  using Milliseconds = std::chrono::milliseconds;

  /// At once if it had worked for kLongLife; else the longer, the more often it died early.
  /// @param life  how long the process has lived
  Milliseconds next(Milliseconds life);

  static constexpr Milliseconds kLongLife{1000}, kFirst{50}, kMax{5000};

 private:
  int early_deaths_ = 0;
};

/// Becomes the parent that keeps a process alive, and returns in the child alone, which goes on
/// with the work. Call it before there are threads.
///
/// A child that is killed, or fails with another code than 2, is replaced, with one record each.
/// The parent passes SIGINT, SIGTERM and SIGHUP on, and ends with the child's code once the child
/// ends well, was told to end, or was called wrongly. A child does not outlive its parent.
/// @throws std::runtime_error if no process can be made
void respawn();

}  // namespace quadrille

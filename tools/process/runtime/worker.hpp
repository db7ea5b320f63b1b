#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "process/runtime/node.hpp"
#include "quadrille/bus/mailbox.hpp"

namespace quadrille {

/// Does the jobs of a mailbox in a thread of its own, so that no job, however long, holds up the
/// rest of the process.
class Worker {
 public:
  /// Both must outlive this.
  /// @param niceness  by how much the thread, and those that it starts, give way to others
  Worker(bus::Mailbox<Job>& mailbox, Node& node, int niceness = 0);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Waits for the job at hand, however long it takes.
  ~Worker();

  /// Takes no further job from the mailbox and waits for the one at hand, at most for so long.
  /// @return whether it has ended
  bool finish(std::chrono::milliseconds patience);

 private:
  void run();

  bus::Mailbox<Job>& mailbox_;
  Node& node_;
  const int niceness_;
  std::atomic<bool> stop_{false};
  std::promise<void> ended_;
  std::thread thread_;
};

}  // namespace quadrille

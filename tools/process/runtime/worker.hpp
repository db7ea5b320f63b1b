#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "process/runtime/node.hpp"
#include "run/mailbox.hpp"

namespace quadrille {

/// Does the jobs of a mailbox in a separate thread, so that no job, however long, delays the rest
/// of the process.
class Worker {
 public:
  /// Both parameters must outlive this object.
  /// @param niceness  niceness of the thread, and of those that it starts, by which they yield to
  /// others
  Worker(bus::Mailbox<Job>& mailbox, Node& node, int niceness = 0);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Waits for the current job, however long it takes.
  ~Worker();

  /// Takes no further job from the mailbox, and waits for the current one until the patience ends.
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

#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "process/runtime/node.hpp"

namespace quadrille {

/// Does the spare jobs of a node in a thread of its own, so that no message waits for them.
class SpareWorker {
 public:
  /// @param node      it must outlive this object
  /// @param niceness  niceness of the thread; it yields to those that work on messages
  SpareWorker(Node& node, int niceness);
  SpareWorker(const SpareWorker&) = delete;
  SpareWorker& operator=(const SpareWorker&) = delete;
  /// Waits for the current job, however long it takes.
  ~SpareWorker();

  /// Takes no further job, and waits for the current one until the patience ends.
  /// @return whether it has ended
  bool finish(std::chrono::milliseconds patience);

 private:
  void run();

  Node& node_;
  const int niceness_;
  std::atomic<bool> stop_{false};
  std::promise<void> ended_;
  std::thread thread_;
};

}  // namespace quadrille

#include "process/runtime/worker.hpp"

#include <signal.h>
#include <sys/resource.h>

namespace quadrille {
namespace {

// A node without a job for so long counts as idle.
constexpr std::chrono::milliseconds kRest(100);

}  // namespace

Worker::Worker(bus::Mailbox<Job>& mailbox, Node& node, int niceness)
    : mailbox_(mailbox), node_(node), niceness_(niceness), thread_([this] { run(); }) {}

Worker::~Worker() {
  stop_ = true;
  thread_.join();
}

bool Worker::finish(std::chrono::milliseconds patience) {
  stop_ = true;
  return ended_.get_future().wait_for(patience) == std::future_status::ready;
}

void Worker::run() {
  // Signals are left to the main thread.
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  // On Linux each thread has its own niceness, so the receiving thread keeps its own. A failure
  // costs only speed.
  if (niceness_ > 0) setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + niceness_);
  auto last_job = std::chrono::steady_clock::now();
  while (!stop_) {
    bool woken = false;
    auto job = mailbox_.take(kRest, &woken);
    if (!job && woken) job = node_.find_early_job();
    const bool is_idle = std::chrono::steady_clock::now() - last_job >= kRest;
    if (!job && is_idle) job = node_.find_spare_job();
    if (!job) continue;
    node_.work(*job);
    last_job = std::chrono::steady_clock::now();
  }
  ended_.set_value();
}

}  // namespace quadrille

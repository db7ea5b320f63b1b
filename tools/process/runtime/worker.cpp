#include "process/runtime/worker.hpp"

#include <signal.h>
#include <sys/resource.h>

namespace quadrille {

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
  while (!stop_) {
    auto job = mailbox_.take(std::chrono::milliseconds(100));
    if (!job) job = node_.find_spare_job();
    if (job) node_.work(*job);
  }
  ended_.set_value();
}

}  // namespace quadrille

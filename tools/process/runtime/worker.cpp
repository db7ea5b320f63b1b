#include "process/runtime/worker.hpp"

#include "process/runtime/background.hpp"

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
  go_to_background(niceness_);
  while (!stop_) {
    bool woken = false;
    auto job = mailbox_.take(std::chrono::milliseconds(100), &woken);
    if (!job && woken) job = node_.find_early_job();
    if (job) node_.work(*job);
  }
  ended_.set_value();
}

}  // namespace quadrille

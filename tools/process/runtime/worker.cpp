#include "process/runtime/worker.hpp"

#include <signal.h>

#include <chrono>

namespace quadrille {

Worker::Worker(bus::Mailbox<Job>& mailbox, Node& node)
    : mailbox_(mailbox), node_(node), thread_([this] { run(); }) {}

Worker::~Worker() {
  stop_ = true;
  thread_.join();
}

void Worker::run() {
  // Signals are for the main thread.
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  while (!stop_) {
    if (const auto job = mailbox_.take(std::chrono::milliseconds(100))) node_.work(*job);
  }
}

}  // namespace quadrille

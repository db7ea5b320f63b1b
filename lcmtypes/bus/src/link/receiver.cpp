#include "link/receiver.hpp"

#include <signal.h>

#include <chrono>
#include <stdexcept>

namespace quadrille::bus {
namespace {

// Largest delay until a stop is noticed [ms].
constexpr int kWaitMs = 100;
// LCM reports a signal and a lost peer in the same way; only a lost peer is reported repeatedly.
constexpr int kFailuresOfLostPeer = 20;
constexpr std::chrono::milliseconds kPauseAfterFailure{10};

}  // namespace

void EndlessHandler::handle(int timeout_ms) {
  if (connection_.handle(timeout_ms) != Connection::Outcome::kEnd) {
    failures_ = 0;
  } else if (++failures_ == kFailuresOfLostPeer) {
    throw std::runtime_error("LCM address " + connection_.url() +
                             ": the connection is lost; start its server and this process anew");
  } else {
    std::this_thread::sleep_for(kPauseAfterFailure);
  }
}

Receiver::Receiver(Connection& connection) : connection_(connection), thread_([this] { run(); }) {}

Receiver::~Receiver() {
  stop_ = true;
  thread_.join();
}

void Receiver::check() {
  const std::lock_guard lock(mutex_);
  if (thrown_) std::rethrow_exception(thrown_);
}

void Receiver::run() noexcept {
  // Signals are left to the main thread.
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  try {
    handle_until_stopped();
  } catch (...) {
    const std::lock_guard lock(mutex_);
    thrown_ = std::current_exception();
  }
}

void Receiver::handle_until_stopped() {
  EndlessHandler handler(connection_);
  while (!stop_) handler.handle(kWaitMs);
}

}  // namespace quadrille::bus

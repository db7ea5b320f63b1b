#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "link/connection.hpp"

namespace quadrille::bus {

/// Handles the messages of a connection that is not expected to end.
class EndlessHandler {
 public:
  /// The connection must outlive this.
  explicit EndlessHandler(Connection& connection) : connection_(connection) {}

  /// Handles one message like Connection::handle().
  /// @throws std::runtime_error if the connection was lost
  void handle(int timeout_ms);

 private:
  Connection& connection_;
  int failures_ = 0;
};

/// Handles the messages of a connection in a thread of its own, which lives as long as this object.
class Receiver {
 public:
  /// Starts the thread. The connection must outlive this; subscribe before.
  explicit Receiver(Connection& connection);
  Receiver(const Receiver&) = delete;
  Receiver& operator=(const Receiver&) = delete;
  ~Receiver();

  /// Rethrows what ended the thread, if anything did: an exception of a handler, or a
  /// std::runtime_error if the connection was lost.
  void check();

 private:
  void run() noexcept;
  void handle_until_stopped();

  Connection& connection_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::exception_ptr thrown_;
  std::thread thread_;
};

}  // namespace quadrille::bus

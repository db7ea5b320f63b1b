#pragma once

#include <lcm/lcm.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/accepted_senders.hpp"

namespace quadrille::bus {

/// A connection to LCM that never falls back to another transport in silence.
class Connection {
 public:
  /// Gets the bytes of one message; they live until it returns.
  using Handler = std::function<void(const std::string& channel, std::span<const std::byte>)>;

  /// How handle() ended.
  enum class Outcome { kHandled, kTimeout, kEnd };

  /// Connects, asking for a large receive buffer where a udpm address names none.
  /// @param url  an LCM address, as resolve_url() gives it
  /// @param senders  whose messages are received over udpm; no other address tells senders
  /// @throws std::invalid_argument if the address cannot be parsed, or cannot tell senders
  /// @throws std::runtime_error if it cannot be reached; says what to do about it
  explicit Connection(const std::string& url, AcceptedSenders senders = {});
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection();

  /// The address that is in use.
  const std::string& url() const { return url_; }

  /// What will go wrong though the connection stands (a receive buffer too small), one line each
  /// with the commands that mend it.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Calls the handler for each message of exactly that channel.
  /// @throws std::invalid_argument if the name is not one to 63 of A-Z a-z 0-9 _ - . /
  /// @throws std::runtime_error if LCM refuses
  void subscribe(const std::string& channel, Handler handler);

  /// Calls the handler for each message of any channel.
  void subscribe_all(Handler handler);

  /// Waits for one message and has it handled. What a handler throws passes around LCM and leaves
  /// here.
  /// @param timeout_ms  how long to wait [ms]
  /// @return kEnd at the end of a log, when the peer is gone, and when a signal came
  Outcome handle(int timeout_ms);

  /// Publishes bytes; may be called from any thread. That datagrams were lost is not reported.
  /// @throws std::invalid_argument if the channel's name is unfit
  /// @throws std::runtime_error if LCM reports a failure
  void publish(const std::string& channel, std::span<const std::byte> bytes);

 private:
  struct Subscriber;

  struct Destroyer {
    void operator()(lcm_t* lcm) const { lcm_destroy(lcm); }
  };

  void add_subscriber(const std::string& pattern, const std::string& channel, Handler handler);
  static void dispatch(const lcm_recv_buf_t* buffer, const char* channel, void* user) noexcept;

  void guard_sockets();

  std::string url_;
  AcceptedSenders senders_;
  std::vector<std::string> warnings_;
  // Outlive lcm_, which calls them.
  std::vector<std::unique_ptr<Subscriber>> subscribers_;
  std::exception_ptr thrown_;
  std::unique_ptr<lcm_t, Destroyer> lcm_;
};

/// Refuses names that LCM would cut off or read as a pattern.
/// @throws std::invalid_argument if the name is not one to 63 of A-Z a-z 0-9 _ - . /
void check_channel(const std::string& channel);

}  // namespace quadrille::bus

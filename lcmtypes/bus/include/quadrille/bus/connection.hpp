#pragma once

#include <lcm/lcm.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/accepted_senders.hpp"
#include "quadrille/bus/backlog.hpp"
#include "quadrille/bus/channel_pattern.hpp"
#include "quadrille/bus/drop_causes.hpp"
#include "quadrille/bus/receive_socket.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// What a connection has received so far, and what was lost on the way to its handlers.
struct Traffic {
  /// The largest message [byte].
  std::int64_t largest_message = 0;
  /// The receive buffer: what was asked for, and what the kernel grants [byte]; 0 where the
  /// transport has none.
  std::int64_t asked_buffer = 0, receive_buffer = 0;
  /// Datagrams that the kernel dropped because the buffer was full: at most as many messages were
  /// lost there. -1 where the system does not tell.
  std::int64_t dropped_datagrams = 0;
  /// Datagrams that the filter of the connection refused: of senders that are not accepted, or such
  /// as no LCM sends.
  std::int64_t filtered_datagrams = 0;
  /// Datagrams dropped for one reason or the other.
  std::int64_t unclear_datagrams = 0;
  /// Messages driven out by newer ones before they were handled.
  std::int64_t dropped_messages = 0;
};

/// Bytes of one channel's messages that wait for their handlers at most, but for the newest.
inline constexpr std::size_t kMaxBacklogBytes = std::size_t{128} << 20;

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
  QUADRILLE_EXPORT explicit Connection(const std::string& url, AcceptedSenders senders = {});
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  QUADRILLE_EXPORT ~Connection();

  /// The address that is in use.
  const std::string& url() const { return url_; }

  /// What looked wrong when the connection was made (a receive buffer too small for a usual cloud),
  /// one line each with the commands that mend it.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Calls the handler for each message of exactly that channel.
  /// @throws std::invalid_argument if the name is not one to 63 of A-Z a-z 0-9 _ - . /
  /// @throws std::runtime_error if LCM refuses
  QUADRILLE_EXPORT void subscribe(const std::string& channel, Handler handler);

  /// Calls the handler for each message of the channels that a pattern matches.
  /// @throws std::runtime_error if LCM refuses
  QUADRILLE_EXPORT void subscribe(const ChannelPattern& pattern, Handler handler);

  /// Waits for one message and has it handled, in the order in which they came. Over UDP whatever
  /// LCM holds is taken out of its queue first: there a burst would drive out the newest uncounted,
  /// here it drives out the oldest, beyond kMaxBacklogBytes, and is counted.
  /// What a handler throws passes around LCM and leaves here.
  /// @param timeout_ms  how long to wait [ms]
  /// @return kEnd at the end of a log, when the peer is gone, and when a signal came
  QUADRILLE_EXPORT Outcome handle(int timeout_ms);

  /// What came and what was lost so far; may be called from any thread.
  QUADRILLE_EXPORT Traffic traffic() const;

  /// Publishes bytes; may be called from any thread. That datagrams were lost is not reported.
  /// @throws std::invalid_argument if the channel's name is unfit
  /// @throws std::runtime_error if LCM reports a failure
  QUADRILLE_EXPORT void publish(const std::string& channel, std::span<const std::byte> bytes);

 private:
  struct Subscriber;

  struct Destroyer {
    void operator()(lcm_t* lcm) const { lcm_destroy(lcm); }
  };

  void add_subscriber(const std::string& pattern, const std::string& channel, Handler handler);
  static void dispatch(const lcm_recv_buf_t* buffer, const char* channel, void* user) noexcept;
  void take(const std::string& channel, std::span<const std::byte> bytes, Subscriber* subscriber);
  bool more_waits() const;
  bool handle_backlog(bool lcm_is_empty);

  void prepare_socket(const std::vector<int>& others);
  void count_drops(Traffic* traffic) const;

  std::string url_;
  AcceptedSenders senders_;
  std::vector<std::string> warnings_;
  // Outlive lcm_, which calls them.
  std::vector<std::unique_ptr<Subscriber>> subscribers_;
  std::exception_ptr thrown_;
  // None where the transport itself holds its sender back.
  std::optional<Backlog> backlog_;
  std::optional<ReceiveSocket> socket_;
  mutable std::mutex drops_mutex_;
  mutable std::optional<DropCauses> drops_;
  std::int64_t asked_buffer_ = 0;
  unsigned turn_ = 0;
  std::atomic<std::int64_t> largest_message_{0}, dropped_messages_{0};
  std::unique_ptr<lcm_t, Destroyer> lcm_;
};

/// Refuses names that LCM would cut off or read as a pattern.
/// @throws std::invalid_argument if the name is not one to 63 of A-Z a-z 0-9 _ - . /
QUADRILLE_EXPORT void check_channel(const std::string& channel);

}  // namespace quadrille::bus

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

#include "link/accepted_senders.hpp"
#include "link/backlog.hpp"
#include "link/channel_pattern.hpp"
#include "link/drop_causes.hpp"
#include "link/receive_socket.hpp"

namespace quadrille::bus {

/// Counts of what a connection has received so far, and of what was lost before its handlers.
struct Traffic {
  /// Size of the largest message [byte].
  std::int64_t largest_message = 0;
  /// Size of the receive buffer that was requested, and size that the kernel grants [byte]; 0 if
  /// the transport has no buffer.
  std::int64_t asked_buffer = 0, receive_buffer = 0;
  /// Datagrams that the kernel dropped because the buffer was full; at most as many messages were
  /// lost there. -1 if the system does not tell.
  std::int64_t dropped_datagrams = 0;
  /// Datagrams that the connection's filter refused, because their sender is not accepted or
  /// because no LCM sends such datagrams.
  std::int64_t filtered_datagrams = 0;
  /// Datagrams dropped for one of these two reasons when it is not known which.
  std::int64_t unclear_datagrams = 0;
  /// Messages that newer ones drove out before they were handled.
  std::int64_t dropped_messages = 0;
};

/// Largest number of bytes that wait for one subscriber's handler, except that its newest message
/// always waits.
inline constexpr std::size_t kMaxBacklogBytes = std::size_t{128} << 20;

/// A connection to LCM that never falls back silently to another transport.
class Connection {
 public:
  /// Receives the bytes of one message, which are valid until it returns.
  using Handler = std::function<void(const std::string& channel, std::span<const std::byte>)>;

  /// Result of handle().
  enum class Outcome { kHandled, kTimeout, kEnd };

  /// Connects, and requests a large receive buffer if a udpm address names none.
  /// @param url  an LCM address, as returned by resolve_url()
  /// @param senders  senders whose messages are accepted; only udpm addresses can tell senders
  /// @throws std::invalid_argument if the address cannot be parsed, or cannot tell senders
  /// @throws std::runtime_error if it cannot be reached; the message says what to do about it
  explicit Connection(const std::string& url, AcceptedSenders senders = {});
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection();

  /// The address that is in use.
  const std::string& url() const { return url_; }

  /// Problems found when the connection was made, such as a receive buffer too small for a usual
  /// cloud; one line each, with the commands that mend it.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Calls the handler for each message of the channel with exactly this name.
  /// @throws std::invalid_argument if the name does not consist of 1 to 63 of A-Z a-z 0-9 _ - . /
  /// @throws std::runtime_error if LCM refuses
  void subscribe(const std::string& channel, Handler handler);

  /// Calls the handler for each message of the channels that a pattern matches.
  /// @throws std::runtime_error if LCM refuses
  void subscribe(const ChannelPattern& channels, Handler handler);

  /// Waits for one message and handles it; messages are handled in the order in which they came.
  /// Over UDP, all messages are first taken out of LCM's own queue, since a burst would drive out
  /// the newest there without being counted. Here it drives out the oldest beyond kMaxBacklogBytes,
  /// and this is counted. An exception of a handler is carried past LCM and rethrown here.
  /// @param timeout_ms  how long to wait [ms]
  /// @return kEnd at the end of a log, if the peer is gone, or if a signal came
  Outcome handle(int timeout_ms);

  /// Returns what came and what was lost so far; may be called from any thread.
  Traffic traffic() const;

  /// Publishes bytes; may be called from any thread. Lost datagrams are not reported.
  /// @throws std::invalid_argument if the channel's name is invalid
  /// @throws std::runtime_error if LCM reports a failure
  void publish(const std::string& channel, std::span<const std::byte> bytes);

 private:
  struct Subscriber;

  struct Destroyer {
    void operator()(lcm_t* lcm) const { lcm_destroy(lcm); }
  };

  static void dispatch(const lcm_recv_buf_t* buffer, const char* channel, void* user) noexcept;
  void take(const std::string& channel, std::span<const std::byte> bytes, Subscriber* subscriber);
  bool more_waits() const;
  bool handle_backlog(bool lcm_is_empty);

  void prepare_socket(const std::vector<int>& others);
  void count_drops(Traffic* traffic) const;

  std::string url_;
  AcceptedSenders senders_;
  std::vector<std::string> warnings_;
  // These must outlive lcm_, which calls them.
  std::vector<std::unique_ptr<Subscriber>> subscribers_;
  std::exception_ptr thrown_;
  // Empty if the transport itself slows its sender down.
  std::optional<Backlog> backlog_;
  std::optional<ReceiveSocket> socket_;
  mutable std::mutex drops_mutex_;
  mutable std::optional<DropCauses> drops_;
  std::int64_t asked_buffer_ = 0;
  unsigned turn_ = 0;
  std::atomic<std::int64_t> largest_message_{0}, dropped_messages_{0};
  std::unique_ptr<lcm_t, Destroyer> lcm_;
};

}  // namespace quadrille::bus

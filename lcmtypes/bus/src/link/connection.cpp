#include "link/connection.hpp"

#include <poll.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "link/datagram_guard.hpp"
#include "link/network.hpp"
#include "link/url.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::bus {
namespace {

/// Adds a large receive buffer to the address if it names none.
/// @return the size requested, and the size that the kernel grants [byte]
std::pair<int, int> set_receive_buffer(Url* url) {
  const auto named = named_receive_buffer(*url);
  const int asked = named.value_or(kMaxReceiveBufferBytes);
  const int granted = granted_receive_buffer(asked);
  // LCM would complain if it requested more than is granted; we report that ourselves, with a
  // remedy.
  if (!named) url->arguments["recv_buf_size"] = std::to_string(granted);
  return {asked, forced_receive_buffer(asked)};
}

std::string failure_to_connect(const Url& url) {
  const std::string start = "LCM address " + url.to_string() + ": ";
  if (url.provider == "file") return start + "cannot be read as an LCM log";
  if (url.provider == "tcpq") {
    return start + "no server answers; start one with: lcm-tcpq-server";
  }
  return start + "LCM cannot open it; check it, or leave --lcm-url and LCM_DEFAULT_URL out";
}

}  // namespace

struct Connection::Subscriber {
  Connection* connection;
  ChannelPattern channels;
  Handler handler;
};

Connection::Connection(const std::string& url, AcceptedSenders senders)
    : senders_(std::move(senders)) {
  Url parsed = parse_url(url);
  const bool is_udpm = parsed.provider == "udpm";
  if (!senders_.all && !is_udpm) {
    throw std::invalid_argument("LCM address " + printable(url) +
                                ": only with udpm can senders be told; leave out --accept-from");
  }
  if (const auto problem = find_route_problem(parsed)) throw std::runtime_error(*problem);
  if (is_udpm) {
    const auto [asked, granted] = set_receive_buffer(&parsed);
    asked_buffer_ = asked;
    if (auto problem = foresee_buffer_problem(asked, granted)) {
      warnings_.push_back(std::move(*problem));
    }
  }
  if (is_udpm || parsed.provider == "mpudpm") backlog_.emplace(kMaxBacklogBytes);
  url_ = parsed.to_string();
  const auto others = is_udpm ? find_receiving_sockets(parsed) : std::vector<int>();
  lcm_.reset(lcm_create(url_.c_str()));
  // Without a server, tcpq seems to connect but aborts when it is waited on.
  if (!lcm_ || lcm_get_fileno(lcm_.get()) < 0) throw std::runtime_error(failure_to_connect(parsed));
  if (is_udpm) prepare_socket(others);
}

Connection::~Connection() = default;

void Connection::subscribe(const std::string& channel, Handler handler) {
  check_channel(channel);
  subscribe(ChannelPattern(channel), std::move(handler));
}

void Connection::subscribe(const ChannelPattern& channels, Handler handler) {
  auto subscriber = std::make_unique<Subscriber>(Subscriber{this, channels, std::move(handler)});
  // LCM puts ^ and $ around the expression.
  const std::string expression = "(" + channels.text() + ")";
  lcm_subscription_t* subscription =
      lcm_subscribe(lcm_.get(), expression.c_str(), &Connection::dispatch, subscriber.get());
  if (subscription == nullptr) {
    throw std::runtime_error("LCM address " + url_ + ": cannot subscribe to '" + channels.text() +
                             "'");
  }
  // LCM's default capacity of 30 silently drops the newest messages, so it is set to unlimited.
  // handle() takes messages out of LCM's queue faster than LCM can add them, into a backlog of
  // limited size.
  lcm_subscription_set_queue_capacity(subscription, 0);
  subscribers_.push_back(std::move(subscriber));
}

/// Attaches the filter to the socket with which LCM receives, and enlarges its buffer.
/// @param others  sockets at that address that existed before
void Connection::prepare_socket(const std::vector<int>& others) {
  const auto errors = read_udp_errors();
  for (const int socket : find_receiving_sockets(parse_url(url_))) {
    if (std::binary_search(others.begin(), others.end(), socket)) continue;
    guard_socket(socket, senders_);
    socket_.emplace(socket);
  }
  if (!socket_) {
    throw std::runtime_error("LCM address " + url_ + ": cannot find LCM's socket to guard it");
  }
  // Everything that the socket has dropped since it was made was refused by the filter, or is
  // counted after `errors` was read.
  if (socket_->dropped() >= 0) drops_.emplace(errors, 0);
  if (socket_->buffer() < asked_buffer_) socket_->force_buffer(asked_buffer_);
}

void Connection::dispatch(const lcm_recv_buf_t* buffer, const char* channel, void* user) noexcept {
  auto* subscriber = static_cast<Subscriber*>(user);
  try {
    // LCM's syntax differs slightly from ours, and it reads a name as an expression too, in which a
    // dot matches any character.
    if (!subscriber->channels.matches(channel)) return;
    subscriber->connection->take(
        channel, {static_cast<const std::byte*>(buffer->data), buffer->data_size}, subscriber);
  } catch (...) {
    if (!subscriber->connection->thrown_)
      subscriber->connection->thrown_ = std::current_exception();
  }
}

/// Handles a message at once and without a copy if no other message waits.
void Connection::take(const std::string& channel, std::span<const std::byte> bytes,
                      Subscriber* subscriber) {
  const auto size = static_cast<std::int64_t>(bytes.size());
  if (size > largest_message_) largest_message_ = size;
  if (!backlog_ || (backlog_->empty() && !more_waits())) {
    subscriber->handler(channel, bytes);
  } else {
    backlog_->push(channel, bytes, subscriber);
    dropped_messages_ = backlog_->dropped();
  }
}

/// True if LCM holds another message, since its descriptor is then readable.
bool Connection::more_waits() const {
  pollfd descriptor{lcm_get_fileno(lcm_.get()), POLLIN, 0};
  return poll(&descriptor, 1, 0) > 0;
}

/// Handles the oldest message of the backlog if LCM's queue is empty, or if it is the backlog's
/// turn.
/// @return true if a message was handled
bool Connection::handle_backlog(bool lcm_is_empty) {
  // Taking a message out of LCM's queue costs far less than LCM spends on putting it in, so this
  // share of the time reaches the handlers even in an endless flood.
  constexpr int kTakenPerHandled = 8;
  if (!lcm_is_empty && ++turn_ % kTakenPerHandled != 0) return false;
  const auto message = backlog_->pop();
  if (!message) return false;
  static_cast<Subscriber*>(message->subscriber)->handler(message->channel, message->bytes);
  return true;
}

Connection::Outcome Connection::handle(int timeout_ms) {
  // If the server is gone, tcpq has no descriptor any more and aborts when it is waited on.
  if (lcm_get_fileno(lcm_.get()) < 0) return Outcome::kEnd;
  const bool behind = backlog_ && !backlog_->empty();
  const int status = lcm_handle_timeout(lcm_.get(), behind ? 0 : timeout_ms);
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  if (behind && handle_backlog(status <= 0)) return Outcome::kHandled;
  if (status < 0) return Outcome::kEnd;
  return status == 0 ? Outcome::kTimeout : Outcome::kHandled;
}

Traffic Connection::traffic() const {
  Traffic traffic;
  traffic.largest_message = largest_message_;
  traffic.dropped_messages = dropped_messages_;
  traffic.asked_buffer = asked_buffer_;
  if (socket_) {
    traffic.receive_buffer = socket_->buffer();
    count_drops(&traffic);
  }
  return traffic;
}

void Connection::count_drops(Traffic* traffic) const {
  traffic->dropped_datagrams = -1;
  if (!drops_) return;
  const std::lock_guard lock(drops_mutex_);
  const auto before = read_udp_errors();
  const std::int64_t dropped = socket_->dropped();
  if (dropped >= 0) drops_->update(before, static_cast<std::uint32_t>(dropped), read_udp_errors());
  traffic->dropped_datagrams = drops_->drops().buffer;
  traffic->filtered_datagrams = drops_->drops().filtered;
  traffic->unclear_datagrams = drops_->drops().unclear;
}

void Connection::publish(const std::string& channel, std::span<const std::byte> bytes) {
  check_channel(channel);
  if (bytes.size() > std::numeric_limits<unsigned>::max() ||
      lcm_publish(lcm_.get(), channel.c_str(), bytes.data(), static_cast<unsigned>(bytes.size())) !=
          0) {
    throw std::runtime_error("LCM address " + url_ + ": cannot publish " +
                             std::to_string(bytes.size()) + " bytes on " + channel);
  }
}

}  // namespace quadrille::bus

#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_static_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/serializer.hpp>
#include <chrono>
#include <memory>
#include <optional>

#include "view/http/http_message.hpp"

namespace quadrille::view {

/// One browser's connection. It reads a request, has a worker make the answer, writes the answer,
/// and reads the next request. It stays alive as long as one of these operations is pending. Except
/// for making answers, everything happens on the one thread that runs the socket's io_context.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  using Clock = std::chrono::steady_clock;

  /// Limit of the request line and all headers [byte]; a browser also sends cookies that other
  /// programs on this machine have set.
  static constexpr std::uint32_t kMaxHeaderBytes = 16384;
  /// Limit of a body [byte]; questions to the planner are the only requests with one.
  static constexpr std::uint64_t kMaxBodyBytes = 1024;
  /// Time within which a whole request must arrive, and within which each part of the answer must
  /// be accepted.
  static constexpr std::chrono::seconds kPatience{5};

  /// @param handler,  workers  must outlive the connection
  HttpConnection(boost::asio::ip::tcp::socket socket, const HttpHandler& handler,
                 boost::asio::thread_pool& workers);

  void read();
  /// Time since when the connection has been waiting for the browser; nullopt while an answer is
  /// made.
  std::optional<Clock::time_point> waits_since() const { return waits_since_; }
  void close();

 private:
  using Error = boost::beast::error_code;
  using Body = boost::beast::http::span_body<const char>;

  void wait_for_browser();
  void take_request(const Error& error);
  void write(HttpAnswer answer);
  void write_some();
  void make_next_part();
  void write_part(std::string part);

  boost::beast::tcp_stream stream_;
  const HttpHandler& handler_;
  boost::asio::thread_pool& workers_;
  boost::beast::flat_static_buffer<kMaxHeaderBytes + kMaxBodyBytes> buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  std::optional<HttpAnswer> answer_;
  std::optional<boost::beast::http::response_serializer<Body>> serializer_;
  std::string part_;
  std::optional<Clock::time_point> waits_since_;
};

}  // namespace quadrille::view

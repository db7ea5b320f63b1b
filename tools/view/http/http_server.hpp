#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "view/http/http_connection.hpp"

namespace quadrille::view {

/// Accepts connections and limits their number.
class HttpServer {
 public:
  /// Number of answers that are made at the same time; other requests wait.
  static constexpr int kWorkers = 32;
  /// Limit of connections; a browser opens up to six. When all places are taken, the browser that
  /// has kept its connection waiting for the longest time loses it.
  static constexpr int kMaxConnections = 128;

  /// Starts serving, in threads of its own.
  /// @param address  a numeric address or a name of this machine
  /// @param port  0 for any free port
  /// @throws boost::system::system_error if it cannot listen there
  HttpServer(const std::string& address, int port, HttpHandler handler);
  /// Waits for answers that are being made, and closes all connections.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const { return acceptor_.local_endpoint().port(); }

 private:
  void listen(const std::string& address, int port);
  void accept();
  void place(boost::asio::ip::tcp::socket socket);
  /// Closes the connection that has been waiting for the longest time.
  /// @return false if no browser is slow
  bool let_slowest_go();

  HttpHandler handler_;
  boost::asio::io_context sockets_{1};
  boost::asio::thread_pool workers_{kWorkers};
  boost::asio::ip::tcp::acceptor acceptor_{sockets_};
  boost::asio::steady_timer retry_{sockets_};
  std::vector<std::weak_ptr<HttpConnection>> connections_;
  std::thread thread_;
};

}  // namespace quadrille::view

#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "view/backend.hpp"
#include "view/request_guard.hpp"

namespace httplib {
class Server;
struct Request;
struct Response;
}  // namespace httplib

namespace quadrille::view {

/// Where the page is served.
struct ServerOptions {
  std::string bind_address = "127.0.0.1";
  /// 0: any that is free.
  int port = 0;
};

/// Serves the page and its data to browsers. Nothing can be changed through it; whether the robot's
/// planner may be asked is up to the backend.
class Server {
 public:
  /// Requests that are worked on, and others that wait for it, at the same time.
  static constexpr int kThreads = 32, kMaxRequests = 64;
  /// Browsers that are told of news; the others ask for them now and then.
  static constexpr int kMaxListeners = 16;
  /// After so long a browser that takes nothing is let go [s].
  static constexpr int kPatience = 5;

  /// Serves from now on, in threads of its own. The backend must outlive this.
  /// @throws std::runtime_error if the port is taken
  Server(Backend& backend, const ServerOptions& options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// "http://127.0.0.1:8765/"
  const std::string& address() const { return address_; }
  int port() const { return port_; }

 private:
  void limit();
  void bind(const ServerOptions& options);
  void add_routes();
  bool admit(const httplib::Request& request, httplib::Response& response) const;
  void tell_news(httplib::Response& response);

  Backend& backend_;
  RequestGuard guard_;
  std::unique_ptr<httplib::Server> server_;
  std::atomic<bool> stopping_{false};
  std::atomic<int> listeners_{0};
  int port_ = 0;
  std::string address_;
  std::thread thread_;
};

}  // namespace quadrille::view

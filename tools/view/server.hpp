#pragma once

#include <memory>
#include <string>

#include "view/backend.hpp"

namespace quadrille::view {

class HttpServer;
class PageRoutes;

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
  /// Browsers that are told of news; the others ask for them now and then.
  static constexpr int kMaxListeners = 16;

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
  std::unique_ptr<PageRoutes> routes_;
  std::unique_ptr<HttpServer> http_;
  int port_;
  std::string address_;
};

}  // namespace quadrille::view

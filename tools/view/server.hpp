#pragma once

#include <memory>
#include <string>

#include "view/backend.hpp"

namespace quadrille::view {

class HttpServer;
class PageRoutes;

/// The address at which the page is served.
struct ServerOptions {
  std::string bind_address = "127.0.0.1";
  /// Port number; 0 for any free port.
  int port = 0;
};

/// Serves the page and its data to browsers. Nothing can be changed through it; the backend decides
/// whether the robot's planner may be asked.
class Server {
 public:
  /// Number of browsers that receive events; the others poll.
  static constexpr int kMaxListeners = 16;

  /// Starts serving, in threads of its own. The backend must outlive the server.
  /// @throws std::runtime_error if the port is taken
  Server(Backend& backend, const ServerOptions& options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Returns the address, such as "http://127.0.0.1:8765/".
  const std::string& address() const { return address_; }
  int port() const { return port_; }

 private:
  std::unique_ptr<PageRoutes> routes_;
  std::unique_ptr<HttpServer> http_;
  int port_;
  std::string address_;
};

}  // namespace quadrille::view

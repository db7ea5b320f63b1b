#include "view/http_server.hpp"

#include <algorithm>
#include <utility>

namespace quadrille::view {

using boost::asio::ip::tcp;

HttpServer::HttpServer(const std::string& address, int port, HttpHandler handler)
    : handler_(std::move(handler)) {
  listen(address, port);
  accept();
  thread_ = std::thread([this] { sockets_.run(); });
}

HttpServer::~HttpServer() {
  sockets_.stop();
  thread_.join();
  workers_.stop();
  workers_.join();
}

void HttpServer::listen(const std::string& address, int port) {
  tcp::resolver resolver(sockets_);
  const tcp::endpoint endpoint =
      *resolver.resolve(address, std::to_string(port), tcp::resolver::passive).begin();
  acceptor_.open(endpoint.protocol());
  // Not SO_REUSEPORT as well: two programs would share one port unawares.
  acceptor_.set_option(tcp::acceptor::reuse_address(true));
  acceptor_.bind(endpoint);
  acceptor_.listen();
}

void HttpServer::accept() {
  acceptor_.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
    std::erase_if(connections_, [](const auto& connection) { return connection.expired(); });
    // An error says that there are no more descriptors.
    const bool is_full = error || connections_.size() >= kMaxConnections;
    const bool has_place = !is_full || let_slowest_go();
    if (has_place && !error) {
      const auto connection =
          std::make_shared<HttpConnection>(std::move(socket), handler_, workers_);
      connections_.push_back(connection);
      connection->read();
    }
    accept();
  });
}

bool HttpServer::let_slowest_go() {
  std::shared_ptr<HttpConnection> slowest;
  for (const auto& place : connections_) {
    const auto connection = place.lock();
    if (!connection || !connection->waits_since()) continue;
    if (!slowest || connection->waits_since() < slowest->waits_since()) slowest = connection;
  }
  if (slowest) slowest->close();
  return slowest != nullptr;
}

}  // namespace quadrille::view

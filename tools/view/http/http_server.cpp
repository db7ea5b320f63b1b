#include "view/http/http_server.hpp"

#include <chrono>
#include <utility>

namespace quadrille::view {

using boost::asio::ip::tcp;

namespace {

/// Time after which the server looks again for a free place: short enough for a user not to notice,
/// and long enough to spare the processor.
constexpr std::chrono::milliseconds kRetryTime{10};
/// No browser loses its connection within this time, so that each of many simultaneous browsers can
/// send its request.
constexpr std::chrono::milliseconds kGraceTime{100};

}  // namespace

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
  // SO_REUSEPORT is not set, because it would let two programs share one port unnoticed.
  acceptor_.set_option(tcp::acceptor::reuse_address(true));
  acceptor_.bind(endpoint);
  acceptor_.listen();
}

void HttpServer::accept() {
  acceptor_.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
    if (!error) return place(std::move(socket));
    // The process has run out of file descriptors.
    let_slowest_go();
    retry_.expires_after(kRetryTime);
    retry_.async_wait([this](const auto&) { accept(); });
  });
}

void HttpServer::place(tcp::socket socket) {
  std::erase_if(connections_, [](const auto& connection) { return connection.expired(); });
  if (connections_.size() >= kMaxConnections && !let_slowest_go()) {
    // No browser is slow, so further ones wait in the kernel's queue.
    retry_.expires_after(kRetryTime);
    return retry_.async_wait(
        [this, socket = std::move(socket)](const auto&) mutable { place(std::move(socket)); });
  }
  const auto connection = std::make_shared<HttpConnection>(std::move(socket), handler_, workers_);
  connections_.push_back(connection);
  connection->read();
  accept();
}

bool HttpServer::let_slowest_go() {
  std::shared_ptr<HttpConnection> slowest;
  for (const auto& place : connections_) {
    const auto connection = place.lock();
    if (!connection || !connection->waits_since()) continue;
    if (!slowest || connection->waits_since() < slowest->waits_since()) slowest = connection;
  }
  if (!slowest || HttpConnection::Clock::now() - *slowest->waits_since() < kGraceTime) return false;
  slowest->close();
  return true;
}

}  // namespace quadrille::view

#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

namespace quadrille::test {

/// A server of LCM's tcpq that greets its first client, serves nothing and goes.
class TcpqServer {
 public:
  TcpqServer() {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bind(socket_, reinterpret_cast<const sockaddr*>(&address_), sizeof address_);
    listen(socket_, 1);
    socklen_t size = sizeof address_;
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address_), &size);
    thread_ = std::thread([this] { greet(); });
  }
  TcpqServer(const TcpqServer&) = delete;
  TcpqServer& operator=(const TcpqServer&) = delete;
  ~TcpqServer() { thread_.join(); }

  std::string url() const { return "tcpq://127.0.0.1:" + std::to_string(ntohs(address_.sin_port)); }

 private:
  void greet() const {
    const int client = accept(socket_, nullptr, nullptr);
    // Its magic number and the version of the protocol.
    const std::array<std::uint32_t, 2> hello = {htonl(0x287617fa), htonl(0x0100)};
    std::array<std::uint32_t, 2> answer{};
    send(client, hello.data(), sizeof hello, 0);
    recv(client, answer.data(), sizeof answer, MSG_WAITALL);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    close(socket_);
    close(client);
  }

  int socket_ = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address_{};
  std::thread thread_;
};

}  // namespace quadrille::test

#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <string>
#include <utility>
#include <vector>

/// A connection to this machine's loopback address.
class TestConnection {
 public:
  explicit TestConnection(int port) {
    socket_.connect({boost::asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)});
  }

  void send(const std::string& bytes) { boost::asio::write(socket_, boost::asio::buffer(bytes)); }

  /// What has come, at most 4096 bytes; waits until something has.
  std::string read_some() {
    std::string text(4096, '\0');
    boost::system::error_code error;
    text.resize(socket_.read_some(boost::asio::buffer(text), error));
    return text;
  }

  boost::asio::ip::tcp::socket& socket() { return socket_; }

 private:
  boost::asio::io_context context_;
  boost::asio::ip::tcp::socket socket_{context_};
};

/// Sends requests as a browser does, each on a connection of its own.
class HttpClient {
 public:
  using Headers = std::vector<std::pair<std::string, std::string>>;
  using Answer = boost::beast::http::response<boost::beast::http::string_body>;

  explicit HttpClient(int port) : port_(port) {}

  Answer get(const std::string& path, const Headers& headers = {}) const {
    return send("GET", path, headers, "");
  }

  Answer send(const std::string& method, const std::string& path, const Headers& headers,
              const std::string& body) const {
    namespace http = boost::beast::http;
    http::request<http::string_body> request(http::string_to_verb(method), path, 11, body);
    request.set(http::field::host, "127.0.0.1:" + std::to_string(port_));
    for (const auto& [name, value] : headers) request.set(name, value);
    request.prepare_payload();
    TestConnection connection(port_);
    http::write(connection.socket(), request);
    boost::beast::flat_buffer buffer;
    http::response_parser<http::string_body> parser;
    parser.body_limit(std::uint64_t{1} << 30);
    parser.skip(method == "HEAD");
    http::read(connection.socket(), buffer, parser);
    return parser.release();
  }

 private:
  int port_;
};

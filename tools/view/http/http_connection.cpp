#include "view/http/http_connection.hpp"

#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <utility>

namespace quadrille::view {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;

namespace {

/// Returns the status that tells a browser what is wrong with its request; none if the browser has
/// gone or is too slow.
std::optional<http::status> refusal_of(const beast::error_code& error) {
  if (error == http::error::end_of_stream || error == http::error::partial_message) return {};
  if (error == http::error::body_limit) return http::status::payload_too_large;
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    return http::status::request_header_fields_too_large;
  }
  const bool is_malformed = error.category() == make_error_code(http::error::bad_method).category();
  return is_malformed ? std::optional(http::status::bad_request) : std::nullopt;
}

}  // namespace

HttpConnection::HttpConnection(net::ip::tcp::socket socket, const HttpHandler& handler,
                               net::thread_pool& workers)
    : stream_(std::move(socket)), handler_(handler), workers_(workers) {}

void HttpConnection::wait_for_browser() {
  waits_since_ = Clock::now();
  stream_.expires_after(kPatience);
}

void HttpConnection::close() {
  waits_since_.reset();
  stream_.close();
}

void HttpConnection::read() {
  serializer_.reset();
  answer_.reset();
  parser_.emplace();
  parser_->header_limit(kMaxHeaderBytes);
  parser_->body_limit(kMaxBodyBytes);
  wait_for_browser();
  http::async_read(
      stream_, buffer_, *parser_,
      [self = shared_from_this()](const Error& error, std::size_t) { self->take_request(error); });
}

void HttpConnection::take_request(const Error& error) {
  if (error) {
    const std::optional<http::status> refusal = refusal_of(error);
    if (!refusal) return;
    HttpAnswer answer = text_answer(*refusal, "text/plain; charset=utf-8",
                                    std::string(http::obsolete_reason(*refusal)) + "\n");
    answer.message.keep_alive(false);
    return write(std::move(answer));
  }
  waits_since_.reset();
  net::post(workers_, [self = shared_from_this()] {
    HttpAnswer answer = self->handler_(self->parser_->get());
    net::post(self->stream_.get_executor(),
              [self, answer = std::move(answer)]() mutable { self->write(std::move(answer)); });
  });
}

void HttpConnection::write(HttpAnswer answer) {
  answer_.emplace(std::move(answer));
  auto& message = answer_->message;
  const HttpRequest& request = parser_->get();
  message.version(request.version());
  if (answer_->next_part) {
    // The end of the connection marks the end of the body.
    message.keep_alive(false);
  } else {
    message.keep_alive(request.keep_alive() && message.keep_alive());
    message.prepare_payload();
  }
  if (request.method() == http::verb::head) {
    message.body() = {};
    answer_->next_part = nullptr;
  }
  serializer_.emplace(message);
  write_some();
}

void HttpConnection::write_some() {
  wait_for_browser();
  http::async_write_some(stream_, *serializer_,
                         [self = shared_from_this()](const Error& error, std::size_t) {
                           if (error) return;
                           if (!self->serializer_->is_done()) return self->write_some();
                           if (self->answer_->next_part) return self->make_next_part();
                           if (self->answer_->message.keep_alive()) self->read();
                         });
}

void HttpConnection::make_next_part() {
  waits_since_.reset();
  net::post(workers_, [self = shared_from_this()] {
    std::string part = self->answer_->next_part();
    net::post(self->stream_.get_executor(), [self, part = std::move(part)]() mutable {
      if (!part.empty()) self->write_part(std::move(part));
    });
  });
}

void HttpConnection::write_part(std::string part) {
  part_ = std::move(part);
  wait_for_browser();
  net::async_write(stream_, net::buffer(part_),
                   [self = shared_from_this()](const Error& error, std::size_t) {
                     if (!error) self->make_next_part();
                   });
}

}  // namespace quadrille::view

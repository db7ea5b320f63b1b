#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/string_body.hpp>
#include <functional>
#include <memory>
#include <string>

namespace quadrille::view {

/// A whole request, within the limits of HttpConnection.
using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;

/// An answer to a request.
struct HttpAnswer {
  /// The message, whose body is a view of bytes, so that large bodies are not copied for each
  /// browser.
  boost::beast::http::response<boost::beast::http::span_body<const char>> message;
  /// Keeps the bytes of the body alive; null if they outlive the server.
  std::shared_ptr<const std::string> bytes;
  /// Makes the next part of a body of unknown length; an empty part ends it. Null if the message is
  /// complete. The function may block, is called on a worker's thread, and must not throw.
  std::function<std::string()> next_part;
};

/// Makes the answer to a request on a worker's thread; many calls run at once. It must not throw.
using HttpHandler = std::function<HttpAnswer(const HttpRequest& request)>;

/// Makes an answer that owns its text.
HttpAnswer text_answer(boost::beast::http::status status, const std::string& type,
                       std::string text);

/// Makes an answer that shares the bytes of its body.
HttpAnswer shared_answer(const std::string& type, std::shared_ptr<const std::string> bytes);

}  // namespace quadrille::view

#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/string_body.hpp>
#include <functional>
#include <memory>
#include <string>

namespace quadrille::view {

/// A whole request, within the bounds of HttpConnection.
using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;

/// An answer to a request.
struct HttpAnswer {
  /// The body is a view of bytes, so that large ones are not copied for each browser.
  boost::beast::http::response<boost::beast::http::span_body<const char>> message;
  /// Keeps the bytes of the body alive; null if they outlast the server.
  std::shared_ptr<const std::string> bytes;
  /// Makes the next part of a body without a known end; an empty part ends it. Null if there is no
  /// more than the message. It may wait, is called on the thread of a worker, and must not throw.
  std::function<std::string()> next_part;
};

/// Makes the answer to a request, on the thread of a worker; many are called at once. It must not
/// throw.
using HttpHandler = std::function<HttpAnswer(const HttpRequest& request)>;

/// An answer whose body is a text of its own.
HttpAnswer text_answer(boost::beast::http::status status, const std::string& type,
                       std::string text);

/// An answer whose body lies in bytes that it shares.
HttpAnswer shared_answer(const std::string& type, std::shared_ptr<const std::string> bytes);

}  // namespace quadrille::view

#include "view/http/http_message.hpp"

#include <utility>

namespace quadrille::view {

namespace http = boost::beast::http;

HttpAnswer text_answer(http::status status, const std::string& type, std::string text) {
  HttpAnswer answer = shared_answer(type, std::make_shared<const std::string>(std::move(text)));
  answer.message.result(status);
  return answer;
}

HttpAnswer shared_answer(const std::string& type, std::shared_ptr<const std::string> bytes) {
  HttpAnswer answer;
  answer.message.set(http::field::content_type, type);
  answer.message.body() = {bytes->data(), bytes->size()};
  answer.bytes = std::move(bytes);
  return answer;
}

}  // namespace quadrille::view

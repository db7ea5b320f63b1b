#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "view/backend.hpp"
#include "view/http_message.hpp"
#include "view/request_guard.hpp"

namespace quadrille::view {

/// Answers the requests of browsers: the page's files and what the backend knows. It may be called
/// from many threads at once.
class PageRoutes {
 public:
  /// @param bind_address   where the server listens
  /// @param max_listeners  browsers that are told of news at the same time
  PageRoutes(Backend& backend, const std::string& bind_address, int max_listeners);

  /// The answer to any request; what the backend throws becomes a status and a line that says why.
  HttpAnswer answer(const HttpRequest& request);
  /// Ends what browsers are told of news.
  void stop() { stopping_ = true; }

 private:
  HttpAnswer answer_or_refuse(const HttpRequest& request);
  HttpAnswer answer_or_throw(const HttpRequest& request);
  HttpAnswer answer_asset(std::size_t index, const HttpRequest& request) const;
  HttpAnswer answer_backend(std::string_view path, std::string_view query);
  HttpAnswer tell_news();

  Backend& backend_;
  RequestGuard guard_;
  std::vector<std::string> packed_assets_;
  int max_listeners_;
  std::atomic<int> listeners_{0};
  std::atomic<bool> stopping_{false};
};

}  // namespace quadrille::view

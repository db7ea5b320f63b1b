#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "view/backend.hpp"
#include "view/http/http_message.hpp"
#include "view/http/request_guard.hpp"

namespace quadrille::view {

/// Answers the requests of browsers with the page's files and the backend's data. May be called
/// from many threads at once.
class PageRoutes {
 public:
  /// @param bind_address  address on which the server listens
  /// @param max_listeners  number of browsers that receive events at the same time
  PageRoutes(Backend& backend, const std::string& bind_address, int max_listeners);

  /// Returns the answer to any request; exceptions of the backend become a status and a line that
  /// says why.
  HttpAnswer answer(const HttpRequest& request);
  /// Ends the events to browsers.
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

#include "view/server.hpp"

#include <fmt/format.h>

#include <boost/system/system_error.hpp>
#include <stdexcept>

#include "view/http/http_server.hpp"
#include "view/page_routes.hpp"

namespace quadrille::view {
namespace {

std::unique_ptr<HttpServer> listen(const ServerOptions& options, HttpHandler handler) {
  try {
    return std::make_unique<HttpServer>(options.bind_address, options.port, std::move(handler));
  } catch (const boost::system::system_error&) {
    throw std::runtime_error(
        fmt::format("view: cannot listen on port {} of {}; choose another --port, or 0 for any, or "
                    "--bind an address of this machine",
                    options.port, options.bind_address));
  }
}

}  // namespace

Server::Server(Backend& backend, const ServerOptions& options)
    : routes_(std::make_unique<PageRoutes>(backend, options.bind_address, kMaxListeners)),
      http_(
          listen(options, [this](const HttpRequest& request) { return routes_->answer(request); })),
      port_(http_->port()) {
  const std::string& host = options.bind_address;
  const bool six = host.find(':') != std::string::npos;
  address_ = fmt::format("http://{}:{}/", six ? fmt::format("[{}]", host) : host, port_);
}

Server::~Server() { routes_->stop(); }

}  // namespace quadrille::view

#include "view/server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <semaphore>
#include <stdexcept>
#include <utility>

#include "view/assets.hpp"
#include "view/pack.hpp"
#include "view/page_requests.hpp"

namespace quadrille::view {
namespace {

/// Only what this program itself serves; styles and labels are set by scripts, none by markup.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

constexpr const char* kQuestionsPath = "/api/questions";
/// The page asks again, so that nothing waits for long when the program ends.
constexpr std::chrono::milliseconds kAnswerWait{1000};

/// Makes the thread that accepts connections wait while too many are open.
class BoundedPool : public httplib::TaskQueue {
 public:
  /// Of older versions void, of newer ones whether there was a place.
  using Enqueued = decltype(std::declval<httplib::TaskQueue&>().enqueue({}));

  Enqueued enqueue(std::function<void()> work) override {
    places_.acquire();
    return threads_.enqueue([this, work = std::move(work)] {
      work();
      places_.release();
    });
  }

  void shutdown() override { threads_.shutdown(); }

 private:
  std::counting_semaphore<Server::kMaxRequests> places_{Server::kMaxRequests};
  httplib::ThreadPool threads_{Server::kThreads};
};

void refuse(httplib::Response& response, int status, const std::string& why) {
  response.status = status;
  response.set_content(why + "\n", "text/plain; charset=utf-8");
}

void send_json(httplib::Response& response, const io::Json& json) {
  response.set_header("Cache-Control", "no-store");
  response.set_content(text_of(json), "application/json");
}

/// Sends a pack without a copy of it for each browser.
void send_pack(httplib::Response& response, const Pack& pack) {
  if (!pack) return refuse(response, 404, "there is no such cloud");
  response.set_header("Cache-Control", "no-store");
  response.set_content_provider(
      pack->size(), "application/octet-stream",
      [pack](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        return sink.write(pack->data() + offset, length);
      });
}

/// The only thing that is sent here. Its type lets no form of another page send it.
bool is_question(const httplib::Request& request) {
  return request.method == "POST" && request.path == kQuestionsPath &&
         request.get_header_value("Content-Type").starts_with("application/json");
}

/// The number in the path of a request.
template <class Number>
Number number_in(const httplib::Request& request) {
  const std::string digits = request.matches[1];
  Number number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace

Server::Server(Backend& backend, const ServerOptions& options)
    : backend_(backend),
      guard_(options.bind_address),
      server_(std::make_unique<httplib::Server>()) {
  limit();
  add_routes();
  bind(options);
  thread_ = std::thread([this] { server_->listen_after_bind(); });
  // It cannot be stopped before.
  while (!server_->is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

Server::~Server() {
  stopping_ = true;
  server_->stop();
  thread_.join();
}

void Server::limit() {
  server_->new_task_queue = [] { return new BoundedPool; };
  server_->set_read_timeout(kPatience);
  server_->set_write_timeout(kPatience);
  server_->set_keep_alive_timeout(1);
  server_->set_payload_max_length(1024);
  // Not SO_REUSEPORT as well: two programs would share one port unawares.
  server_->set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server_->set_exception_handler([](const auto&, auto& response, std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const NotAllowed& error) {
      refuse(response, 403, error.what());
    } catch (const TooManyQuestions& error) {
      refuse(response, 429, error.what());
    } catch (const std::out_of_range& error) {
      refuse(response, 404, error.what());
    } catch (const std::invalid_argument& error) {
      refuse(response, 400, error.what());
    } catch (const std::exception& error) {
      refuse(response, 500, error.what());
    } catch (...) {
      refuse(response, 500, "failed");
    }
  });
}

void Server::bind(const ServerOptions& options) {
  const std::string& host = options.bind_address;
  const bool any = options.port == 0;
  port_ = any ? server_->bind_to_any_port(host) : options.port;
  if (port_ <= 0 || (!any && !server_->bind_to_port(host, port_))) {
    throw std::runtime_error(
        fmt::format("view: cannot listen on port {} of {}; choose another --port, or 0 for any, or "
                    "--bind an address of this machine",
                    options.port, host));
  }
  const bool six = host.find(':') != std::string::npos;
  address_ = fmt::format("http://{}:{}/", six ? fmt::format("[{}]", host) : host, port_);
}

bool Server::admit(const httplib::Request& request, httplib::Response& response) const {
  response.set_header("Content-Security-Policy", kContentSecurityPolicy);
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  const std::string host = request.get_header_value("Host");
  if (!guard_.allows_host(host)) {
    refuse(response, 403, "this view is for its own machine: open it by its address");
  } else if (!guard_.allows_origin(request.get_header_value("Origin"), host)) {
    refuse(response, 403, "this view is not for other pages");
  } else if (!is_question(request) && request.method != "GET" && request.method != "HEAD") {
    refuse(response, 405, "nothing can be changed here");
  } else {
    return true;
  }
  return false;
}

void Server::add_routes() {
  using httplib::Request;
  using httplib::Response;
  server_->set_pre_routing_handler([this](const Request& request, Response& response) {
    return admit(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                    : httplib::Server::HandlerResponse::Handled;
  });
  for (const Asset& asset : assets()) {
    server_->Get("/" + asset.name, [asset](const Request&, Response& response) {
      response.set_header("Cache-Control", "no-cache");
      response.set_content(asset.content.data(), asset.content.size(), asset.type);
    });
  }
  server_->Get("/api/session", [this](const Request&, Response& response) {
    send_json(response, backend_.session());
  });
  server_->Get("/api/status", [this](const Request&, Response& response) {
    send_json(response, backend_.status());
  });
  server_->Get(R"(/api/frames/(\d{1,9}))", [this](const Request& request, Response& response) {
    const PlanChoice choice =
        read_choice(request.get_param_value("gripper"), request.get_param_value("unknown"),
                    request.get_param_value("clearance"));
    send_pack(response, backend_.frame(number_in<std::size_t>(request), choice));
  });
  server_->Post(kQuestionsPath, [this](const Request& request, Response& response) {
    send_json(response, {{"number", backend_.ask(read_question(request.body))}});
  });
  server_->Get(R"(/api/questions/(\d{1,16}))", [this](const Request& request, Response& response) {
    const auto number = number_in<std::int64_t>(request);
    send_json(response, {{"answer", backend_.wait_answer(number, kAnswerWait)}});
  });
  server_->Get("/api/newest", [this](const Request&, Response& response) {
    send_pack(response, backend_.newest());
  });
  server_->Get("/api/events", [this](const Request&, Response& response) { tell_news(response); });
}

/// Server-sent events: the number of the newest scene and the status. A browser that is busy or
/// slow misses some numbers, and nothing waits for it: it fetches the newest scene when it can.
void Server::tell_news(httplib::Response& response) {
  if (++listeners_ > kMaxListeners) {
    --listeners_;
    return refuse(response, 503, "too many browsers are listening");
  }
  response.set_header("Cache-Control", "no-store");
  const auto version = std::make_shared<std::uint64_t>(0);
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, version](std::size_t, httplib::DataSink& sink) {
        if (stopping_) return false;
        *version = backend_.wait_newer(*version, std::chrono::seconds(1));
        const std::string event =
            "data: " + text_of({{"version", *version}, {"status", backend_.status()}}) + "\n\n";
        return !stopping_ && sink.write(event.data(), event.size());
      },
      [this](bool) { --listeners_; });
}

}  // namespace quadrille::view

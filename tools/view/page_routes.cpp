#include "view/page_routes.hpp"

#include <algorithm>
#include <boost/beast/http/rfc7230.hpp>
#include <charconv>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "io/gzip.hpp"
#include "view/assets.hpp"
#include "view/page_requests.hpp"
#include "view/scene/pack.hpp"

namespace quadrille::view {
namespace {

namespace http = boost::beast::http;

/// Allows only what this program itself serves. Scripts set the styles and labels, so markup needs
/// none.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

constexpr std::string_view kQuestionsPath = "/api/questions", kFramesPath = "/api/frames";
/// Longest wait for an answer in one request. The page asks again, so that nothing waits for long
/// when the program ends.
constexpr std::chrono::milliseconds kAnswerWait{1000};

HttpAnswer refusal(http::status status, const std::string& why) {
  return text_answer(status, "text/plain; charset=utf-8", why + "\n");
}

HttpAnswer json_answer(const io::Json& json) {
  HttpAnswer answer = text_answer(http::status::ok, "application/json", text_of(json));
  answer.message.set(http::field::cache_control, "no-store");
  return answer;
}

HttpAnswer pack_answer(const Pack& pack) {
  if (!pack) return refusal(http::status::not_found, "there is no such cloud");
  HttpAnswer answer = shared_answer("application/octet-stream", pack);
  answer.message.set(http::field::cache_control, "no-store");
  return answer;
}

std::string value_of(const HttpRequest& request, http::field field) {
  const auto value = request[field];
  return {value.data(), value.size()};
}

/// Returns the number after "PREFIX/"; nullopt if the path is another one, or has more digits.
template <class Number>
std::optional<Number> number_after(std::string_view prefix, std::string_view path,
                                   std::ptrdiff_t max_digits) {
  if (!path.starts_with(prefix)) return std::nullopt;
  path.remove_prefix(prefix.size());
  if (!path.starts_with('/') || path.starts_with("/-")) return std::nullopt;
  path.remove_prefix(1);
  Number number = 0;
  const char* const end = path.data() + path.size();
  const auto [last, error] = std::from_chars(path.data(), end, number);
  if (error != std::errc{} || last != end || end - path.data() > max_digits) return std::nullopt;
  return number;
}

/// Returns true for a question, the only kind of request that sends data. Its media type prevents
/// forms of other pages from sending it.
bool is_question(const HttpRequest& request) {
  return request.method() == http::verb::post && request.target() == kQuestionsPath.data() &&
         value_of(request, http::field::content_type).starts_with("application/json");
}

}  // namespace

PageRoutes::PageRoutes(Backend& backend, const std::string& bind_address, int max_listeners)
    : backend_(backend), guard_(bind_address), max_listeners_(max_listeners) {
  for (const Asset& asset : assets()) {
    packed_assets_.push_back(io::gzip(asset.content));
  }
}

HttpAnswer PageRoutes::answer_or_refuse(const HttpRequest& request) {
  try {
    return answer_or_throw(request);
  } catch (const NotAllowed& error) {
    return refusal(http::status::forbidden, error.what());
  } catch (const TooManyQuestions& error) {
    return refusal(http::status::too_many_requests, error.what());
  } catch (const std::out_of_range& error) {
    return refusal(http::status::not_found, error.what());
  } catch (const std::invalid_argument& error) {
    return refusal(http::status::bad_request, error.what());
  } catch (const std::exception& error) {
    return refusal(http::status::internal_server_error, error.what());
  } catch (...) {
    return refusal(http::status::internal_server_error, "failed");
  }
}

HttpAnswer PageRoutes::answer(const HttpRequest& request) {
  HttpAnswer answer = answer_or_refuse(request);
  answer.message.set("Content-Security-Policy", kContentSecurityPolicy);
  answer.message.set("X-Content-Type-Options", "nosniff");
  answer.message.set("Referrer-Policy", "no-referrer");
  answer.message.set("Cross-Origin-Resource-Policy", "same-origin");
  return answer;
}

HttpAnswer PageRoutes::answer_or_throw(const HttpRequest& request) {
  const std::string host = value_of(request, http::field::host);
  if (!guard_.allows_host(host)) {
    return refusal(http::status::forbidden,
                   "this view is for its own machine: open it by its address");
  }
  if (!guard_.allows_origin(value_of(request, http::field::origin), host)) {
    return refusal(http::status::forbidden, "this view is not for other pages");
  }
  if (is_question(request)) {
    return json_answer({{"number", backend_.ask(read_question(request.body()))}});
  }
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    return refusal(http::status::method_not_allowed, "nothing can be changed here");
  }
  const std::string_view target(request.target().data(), request.target().size());
  const std::string_view path = target.substr(0, target.find('?'));
  for (std::size_t i = 0; i < assets().size(); ++i) {
    if (path == "/" + assets()[i].name) return answer_asset(i, request);
  }
  return answer_backend(path, target.substr(std::min(path.size() + 1, target.size())));
}

/// Serves a file of the page, compressed if the browser accepts that.
HttpAnswer PageRoutes::answer_asset(std::size_t index, const HttpRequest& request) const {
  const Asset& asset = assets()[index];
  HttpAnswer answer;
  answer.message.set(http::field::content_type, asset.type);
  answer.message.set(http::field::cache_control, "no-cache");
  answer.message.body() = asset.content;
  if (http::ext_list(request[http::field::accept_encoding]).exists("gzip")) {
    answer.message.set(http::field::content_encoding, "gzip");
    answer.message.body() = packed_assets_[index];
  }
  return answer;
}

HttpAnswer PageRoutes::answer_backend(std::string_view path, std::string_view query) {
  if (path == "/api/session") return json_answer(backend_.session());
  if (path == "/api/status") return json_answer(backend_.status());
  if (path == "/api/newest") return pack_answer(backend_.newest());
  if (path == "/api/events") return tell_news();
  if (const auto number = number_after<std::size_t>(kFramesPath, path, 9)) {
    const PlanChoice choice =
        read_choice(query_value(query, "gripper"), query_value(query, "unknown"),
                    query_value(query, "clearance"));
    return pack_answer(backend_.frame(*number, choice));
  }
  if (const auto number = number_after<std::int64_t>(kQuestionsPath, path, 16)) {
    return json_answer({{"answer", backend_.wait_answer(*number, kAnswerWait)}});
  }
  return refusal(http::status::not_found, "there is no such page");
}

/// Sends server-sent events with the number of the newest scene and the status. A browser that is
/// busy or slow misses some numbers, and nothing waits for it: it fetches the newest scene when it
/// can.
HttpAnswer PageRoutes::tell_news() {
  ++listeners_;
  const std::shared_ptr<void> place(nullptr, [this](void*) { --listeners_; });
  if (listeners_ > max_listeners_) {
    return refusal(http::status::service_unavailable, "too many browsers are listening");
  }
  HttpAnswer answer;
  answer.message.set(http::field::content_type, "text/event-stream");
  answer.message.set(http::field::cache_control, "no-store");
  answer.next_part = [this, place, version = std::uint64_t{0}]() mutable -> std::string {
    if (!stopping_) version = backend_.wait_newer(version, std::chrono::seconds(1));
    if (stopping_) return "";
    return "data: " + text_of({{"version", version}, {"status", backend_.status()}}) + "\n\n";
  };
  return answer;
}

}  // namespace quadrille::view

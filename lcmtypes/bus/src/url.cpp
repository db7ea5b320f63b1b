#include "quadrille/bus/url.hpp"

#include <charconv>
#include <cstdlib>
#include <stdexcept>

namespace quadrille::bus {
namespace {

void parse_arguments(const std::string& text, Url* url) {
  std::size_t start = 0;
  while (start < text.size()) {
    std::size_t end = text.find_first_of("&,", start);
    if (end == std::string::npos) end = text.size();
    const std::string pair = text.substr(start, end - start);
    const std::size_t equals = pair.find('=');
    if (equals != std::string::npos) {
      url->arguments[pair.substr(0, equals)] = pair.substr(equals + 1);
    }
    start = end + 1;
  }
}

}  // namespace

std::string Url::to_string() const {
  std::string text = provider + "://" + network;
  char separator = '?';
  for (const auto& [key, value] : arguments) {
    text += separator + key + "=" + value;
    separator = '&';
  }
  return text;
}

Url parse_url(const std::string& text) {
  const std::size_t colon = text.find("://");
  if (colon == std::string::npos || colon == 0) {
    throw std::invalid_argument("LCM address '" + text +
                                "': must look like udpm://239.255.76.67:7667?ttl=0");
  }
  Url url;
  url.provider = text.substr(0, colon);
  const std::size_t start = colon + 3;
  const std::size_t question = text.find('?', start);
  url.network = text.substr(start, question == std::string::npos ? question : question - start);
  if (question != std::string::npos) parse_arguments(text.substr(question + 1), &url);
  return url;
}

void check_live(const Url& url) {
  const std::string start = "LCM address '" + url.to_string() + "': ";
  if (url.provider == "memq") {
    throw std::invalid_argument(start + "memq reaches no other process; give a udpm or tcpq one");
  }
  if (url.provider == "file") {
    throw std::invalid_argument(start + "a log is no bus; replay it with --in-log and --out-log");
  }
  const auto found = url.arguments.find("ttl");
  if (found == url.arguments.end()) return;
  const std::string& ttl = found->second;
  int hops = -1;
  const auto [rest, error] = std::from_chars(ttl.data(), ttl.data() + ttl.size(), hops);
  const bool fit = error == std::errc{} && rest == ttl.data() + ttl.size();
  if (!fit || hops < 0 || hops > 255) {
    throw std::invalid_argument(start + "ttl = '" + ttl +
                                "' must be 0 (this machine), 1 (this network) or up to 255");
  }
}

std::string resolve_url(const std::string& option) {
  if (!option.empty()) return option;
  const char* environment = std::getenv("LCM_DEFAULT_URL");
  if (environment != nullptr && *environment != '\0') return environment;
  return "udpm://239.255.76.67:7667?ttl=0";
}

}  // namespace quadrille::bus

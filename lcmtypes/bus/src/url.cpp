#include "quadrille/bus/url.hpp"

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

std::string resolve_url(const std::string& option) {
  if (!option.empty()) return option;
  const char* environment = std::getenv("LCM_DEFAULT_URL");
  if (environment != nullptr && *environment != '\0') return environment;
  return "udpm://239.255.76.67:7667?ttl=0";
}

std::string replay_url(const std::string& path) {
  if (path.empty() || path.find_first_of("?&,") != std::string::npos) {
    throw std::invalid_argument("log '" + path +
                                "': LCM cannot replay a path with '?', '&' or ','; rename it");
  }
  return "file://" + path + "?speed=0";
}

}  // namespace quadrille::bus

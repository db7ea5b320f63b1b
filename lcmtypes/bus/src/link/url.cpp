#include "link/url.hpp"

#include <arpa/inet.h>

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "quadrille/detector/printable.hpp"

namespace quadrille::bus {
namespace {

constexpr const char* kDefaultNetwork = "239.255.76.67:7667";

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

std::optional<int> number_in(const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return value;
}

[[noreturn]] void refuse_address(const Url& url, const std::string& why) {
  throw std::invalid_argument("LCM address '" + printable(url.to_string()) + "': " + why);
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
    throw std::invalid_argument("LCM address '" + printable(text) +
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

sockaddr_in multicast_group(const Url& url) {
  const std::string network = url.network.empty() ? kDefaultNetwork : url.network;
  const std::size_t colon = network.find(':');
  const int port =
      colon == std::string::npos ? 0 : number_in(network.substr(colon + 1)).value_or(0);
  sockaddr_in group = {};
  group.sin_family = AF_INET;
  if (inet_pton(AF_INET, network.substr(0, colon).c_str(), &group.sin_addr) != 1 || port < 1 ||
      port > std::numeric_limits<std::uint16_t>::max()) {
    refuse_address(url,
                   "'" + printable(network) + "' must be ADDRESS:PORT, such as " + kDefaultNetwork);
  }
  if (!IN_MULTICAST(ntohl(group.sin_addr.s_addr))) {
    refuse_address(url,
                   printable(network.substr(0, colon)) +
                       " is no multicast address (224.0.0.0 to 239.255.255.255); give udpm://" +
                       kDefaultNetwork + "?ttl=0");
  }
  group.sin_port = htons(static_cast<std::uint16_t>(port));
  return group;
}

std::optional<int> named_receive_buffer(const Url& url) {
  const auto named = url.arguments.find("recv_buf_size");
  if (named == url.arguments.end()) return std::nullopt;
  const auto bytes = number_in(named->second);
  if (!bytes || *bytes <= 0) {
    refuse_address(url, "recv_buf_size = '" + printable(named->second) +
                            "' must be a number of bytes from 1 to " +
                            std::to_string(std::numeric_limits<int>::max()));
  }
  return bytes;
}

void check_live(const Url& url) {
  if (url.provider == "memq") {
    refuse_address(url, "memq reaches no other process; give a udpm or tcpq one");
  }
  if (url.provider == "file") {
    refuse_address(url, "a log is no bus; replay it with --in-log and --out-log");
  }
  if (url.provider != "udpm" && url.provider != "mpudpm" && url.provider != "tcpq") {
    refuse_address(url, "LCM has no '" + printable(url.provider) + "'; give a udpm or tcpq one");
  }
  if (url.provider == "udpm") multicast_group(url);
  named_receive_buffer(url);
  const auto ttl = url.arguments.find("ttl");
  if (ttl == url.arguments.end()) return;
  const auto hops = number_in(ttl->second);
  if (!hops || *hops < 0 || *hops > 255) {
    refuse_address(url, "ttl = '" + printable(ttl->second) +
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

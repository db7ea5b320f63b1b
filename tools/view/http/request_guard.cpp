#include "view/http/request_guard.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <cctype>

namespace quadrille::view {
namespace {

/// Returns "[::1]:80" or "localhost:80" without port and brackets; empty if it is malformed.
std::string name_of_host(const std::string& host) {
  const bool bracketed = host.starts_with('[');
  const std::size_t end = bracketed ? host.find(']') : host.find(':');
  if (bracketed && end == std::string::npos) return "";
  const std::size_t rest = end == std::string::npos ? host.size() : end + (bracketed ? 1 : 0);
  const std::string port = host.substr(rest);
  const bool digits = port.size() > 1 && std::all_of(port.begin() + 1, port.end(), [](char c) {
                        return std::isdigit(static_cast<unsigned char>(c)) != 0;
                      });
  if (!port.empty() && (port[0] != ':' || !digits)) return "";
  return bracketed ? host.substr(1, end - 1) : host.substr(0, rest);
}

bool is_number(const std::string& address) {
  in6_addr parsed;
  return inet_pton(AF_INET, address.c_str(), &parsed) == 1 ||
         inet_pton(AF_INET6, address.c_str(), &parsed) == 1;
}

}  // namespace

bool is_loopback(const std::string& address) {
  return address == "localhost" || address == "::1" ||
         (is_number(address) && address.starts_with("127."));
}

RequestGuard::RequestGuard(const std::string& bind_address)
    : loopback_only_(is_loopback(bind_address)) {}

bool RequestGuard::allows_host(const std::string& host) const {
  const std::string name = name_of_host(host);
  return is_loopback(name) || (!loopback_only_ && is_number(name));
}

bool RequestGuard::allows_origin(const std::string& origin, const std::string& host) const {
  return origin.empty() || (allows_host(host) && origin == "http://" + host);
}

}  // namespace quadrille::view

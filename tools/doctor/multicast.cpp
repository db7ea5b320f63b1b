#include "doctor/multicast.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace quadrille::doctor {
namespace {

std::string host_of(const sockaddr_in& address) {
  std::array<char, INET_ADDRSTRLEN> text{};
  inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size());
  return text.data();
}

/// Returns the sender address of datagrams from this machine to the group; nullopt if there is no
/// route.
std::optional<std::string> own_address(const sockaddr_in& group) {
  const Socket socket;
  // Connecting a UDP socket sends nothing; it only looks up the route.
  if (connect(socket.get(), reinterpret_cast<const sockaddr*>(&group), sizeof group) != 0)
    return {};
  sockaddr_in own = {};
  socklen_t size = sizeof own;
  if (getsockname(socket.get(), reinterpret_cast<sockaddr*>(&own), &size) != 0) return {};
  return host_of(own);
}

/// Returns the interface of the most specific route to an address; empty if there is none. The
/// machine's own address does not determine it: over lo it is 0.0.0.0.
std::string name_of_interface(in_addr_t to) {
  std::ifstream table("/proc/net/route");
  std::string line, best;
  std::getline(table, line);
  std::uint32_t narrowest = 0, least_metric = 0;
  while (std::getline(table, line)) {
    std::istringstream words(line);
    std::string name, skipped;
    std::uint32_t destination = 0, flags = 0, metric = 0, mask = 0;
    words >> name >> std::hex >> destination >> skipped >> flags >> skipped >> skipped >>
        std::dec >> metric >> std::hex >> mask;
    constexpr std::uint32_t kUp = 0x1, kReject = 0x200;
    if (!words || (flags & (kUp | kReject)) != kUp || (to & mask) != destination) continue;
    const bool better = best.empty() || ntohl(mask) > narrowest ||
                        (ntohl(mask) == narrowest && metric < least_metric);
    if (!better) continue;
    best = name;
    narrowest = ntohl(mask);
    least_metric = metric;
  }
  return best;
}

}  // namespace

Socket::Socket() : fd_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  if (fd_ < 0) throw std::runtime_error(fmt::format("no UDP socket: {}", std::strerror(errno)));
}

Socket::~Socket() { close(fd_); }

std::string to_text(const sockaddr_in& address) {
  return fmt::format("{}:{}", host_of(address), ntohs(address.sin_port));
}

std::optional<Interface> interface_to(const sockaddr_in& group) {
  const auto own = own_address(group);
  ifaddrs* list = nullptr;
  if (!own || getifaddrs(&list) != 0) return std::nullopt;
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owner(list, &freeifaddrs);
  const std::string name = name_of_interface(group.sin_addr.s_addr);
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_name != name) continue;
    return Interface{name, *own, (entry->ifa_flags & IFF_LOOPBACK) != 0,
                     (entry->ifa_flags & IFF_MULTICAST) != 0};
  }
  // The route is in another routing table, whose interface is unknown here.
  return Interface{"an interface", *own, false, true};
}

}  // namespace quadrille::doctor

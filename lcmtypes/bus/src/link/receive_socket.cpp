#include "link/receive_socket.hpp"

#include <arpa/inet.h>
#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <string>

namespace quadrille::bus {
namespace {

bool receives_at(int fd, in_port_t port) {
  sockaddr_in address = {};
  socklen_t size = sizeof(address);
  if (getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) != 0) return false;
  int type = 0;
  socklen_t type_size = sizeof(type);
  return address.sin_family == AF_INET && address.sin_port == port &&
         getsockopt(fd, SOL_SOCKET, SO_TYPE, &type, &type_size) == 0 && type == SOCK_DGRAM;
}

}  // namespace

std::vector<int> find_receiving_sockets(const Url& url) {
  const in_port_t port = multicast_group(url).sin_port;
  std::error_code error;
  std::vector<int> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = entry.path().filename();
    int fd = -1;
    std::from_chars(name.data(), name.data() + name.size(), fd);
    if (fd >= 0 && receives_at(fd, port)) found.push_back(fd);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::int64_t ReceiveSocket::buffer() const {
  int doubled = 0;
  socklen_t size = sizeof(doubled);
  if (getsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &doubled, &size) != 0) return 0;
  // The kernel doubles the size for its own bookkeeping, and reports the doubled value.
  return doubled / 2;
}

void ReceiveSocket::force_buffer(std::int64_t bytes) {
  const int asked = static_cast<int>(bytes);
  // If the kernel refuses, buffer() shows it.
  setsockopt(fd_, SOL_SOCKET, SO_RCVBUFFORCE, &asked, sizeof(asked));
}

std::int64_t ReceiveSocket::dropped() const {
  std::array<std::uint32_t, SK_MEMINFO_VARS> info{};
  socklen_t size = sizeof(info);
  if (getsockopt(fd_, SOL_SOCKET, SO_MEMINFO, info.data(), &size) != 0 ||
      size < (SK_MEMINFO_DROPS + 1) * sizeof(std::uint32_t)) {
    return -1;
  }
  return info[SK_MEMINFO_DROPS];
}

}  // namespace quadrille::bus

#include "doctor/listen.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "doctor/multicast.hpp"
#include "link/network.hpp"
#include "run/clock.hpp"

namespace quadrille::doctor {
namespace {

using Clock = std::chrono::steady_clock;

void join(const Socket& socket, const sockaddr_in& group) {
  const int on = 1, buffer = bus::kReceiveBufferBytes;
  setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  setsockopt(socket.get(), SOL_SOCKET, SO_REUSEPORT, &on, sizeof on);
  setsockopt(socket.get(), SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
  // A socket bound to the group, not to all addresses, takes no datagrams away from others.
  ip_mreq membership = {};
  membership.imr_multiaddr = group.sin_addr;
  if (bind(socket.get(), reinterpret_cast<const sockaddr*>(&group), sizeof group) != 0 ||
      setsockopt(socket.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) !=
          0) {
    throw std::runtime_error(fmt::format("cannot listen to the multicast group {}: {}",
                                         to_text(group), std::strerror(errno)));
  }
}

/// Returns the time left until then, at least 0.
int ms_until(Clock::time_point end) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
  return left > 0 ? static_cast<int>(left) : 0;
}

}  // namespace

Traffic listen(const bus::Url& url, std::chrono::milliseconds duration, PoseRecorder* poses) {
  const Socket socket;
  join(socket, bus::multicast_group(url));
  Traffic traffic;
  std::vector<std::byte> buffer(1 << 16);
  const Clock::time_point end = Clock::now() + duration;
  for (int left = ms_until(end); left > 0; left = ms_until(end)) {
    pollfd waiting = {socket.get(), POLLIN, 0};
    if (poll(&waiting, 1, left) <= 0) continue;
    sockaddr_in from = {};
    socklen_t size = sizeof from;
    const ssize_t got = recvfrom(socket.get(), buffer.data(), buffer.size(), MSG_DONTWAIT,
                                 reinterpret_cast<sockaddr*>(&from), &size);
    if (got < 0) continue;
    const std::string sender = to_text(from);
    const auto datagram = std::span(buffer).first(static_cast<std::size_t>(got));
    const std::int64_t now = bus::wall_clock_utime();
    traffic.add(sender, datagram, now);
    poses->add(sender, datagram, now);
  }
  return traffic;
}

}  // namespace quadrille::doctor

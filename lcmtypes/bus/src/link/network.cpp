#include "link/network.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "link/receive_socket.hpp"

namespace quadrille::bus {
namespace {

class UdpSocket {
 public:
  UdpSocket() : fd_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    if (fd_ < 0) throw std::runtime_error(std::string("no UDP socket: ") + std::strerror(errno));
  }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;
  ~UdpSocket() { close(fd_); }

  int get() const { return fd_; }

 private:
  int fd_;
};

/// The receive buffer that the kernel grants through one of its socket options [byte].
int granted(int option, int asked) {
  const UdpSocket socket;
  setsockopt(socket.get(), SOL_SOCKET, option, &asked, sizeof(asked));
  return static_cast<int>(ReceiveSocket(socket.get()).buffer());
}

}  // namespace

std::optional<std::string> find_route_problem(const Url& url) {
  if (url.provider != "udpm") return std::nullopt;
  const sockaddr_in group = multicast_group(url);
  const UdpSocket socket;
  // Connecting a UDP socket sends nothing; it only looks up the route.
  if (connect(socket.get(), reinterpret_cast<const sockaddr*>(&group), sizeof(group)) == 0) {
    return std::nullopt;
  }
  return "no route to the multicast group " + url.network + " (" + std::strerror(errno) +
         "); mend it with: sudo ip link set lo up && sudo ip route add 224.0.0.0/4 dev lo";
}

std::int64_t needed_receive_buffer(std::int64_t message_bytes) { return 2 * message_bytes; }

int advised_receive_buffer(std::int64_t message_bytes) {
  constexpr std::int64_t kBurst = 8;
  constexpr int kMost = 1 << 30;
  int bytes = kReceiveBufferBytes;
  while (bytes < kMost && bytes / kBurst < message_bytes) bytes *= 2;
  return bytes;
}

std::string mend_receive_buffer(std::int64_t asked, int wanted) {
  const std::string size = std::to_string(wanted);
  std::string cure;
  if (granted_receive_buffer(wanted) < wanted) {
    const std::string setting = "net.core.rmem_max=" + size;
    cure = "sudo sysctl -w " + setting + " (and to keep it: echo " + setting +
           " | sudo tee /etc/sysctl.d/60-lcm.conf)";
  }
  if (asked < wanted) {
    if (!cure.empty()) cure += ", and ";
    cure += "recv_buf_size=" + size + " in the LCM address";
  }
  return cure + (cure.empty() ? "start the process again" : "; then start the process again");
}

std::optional<std::string> find_buffer_problem(std::int64_t asked, std::int64_t granted,
                                               std::int64_t message_bytes) {
  if (granted >= needed_receive_buffer(message_bytes)) return std::nullopt;
  return "the receive buffer of " + std::to_string(granted) +
         " bytes is too small for messages of " + std::to_string(message_bytes) +
         " bytes, which will be lost; mend it with: " +
         mend_receive_buffer(asked, advised_receive_buffer(message_bytes));
}

std::optional<std::string> foresee_buffer_problem(std::int64_t asked, std::int64_t granted) {
  if (granted >= needed_receive_buffer(kUsualCloudBytes)) return std::nullopt;
  return "the receive buffer of " + std::to_string(granted) + " bytes would lose clouds of " +
         std::to_string(kUsualCloudBytes) +
         " bytes (640x480 points), if such come; mend it with: " +
         mend_receive_buffer(asked, advised_receive_buffer(kUsualCloudBytes));
}

int granted_receive_buffer(int asked) { return granted(SO_RCVBUF, asked); }

int forced_receive_buffer(int asked) {
  return std::max(granted(SO_RCVBUFFORCE, asked), granted_receive_buffer(asked));
}

}  // namespace quadrille::bus

#pragma once

#include <netinet/in.h>

#include <optional>
#include <string>

namespace quadrille::doctor {

/// Formats an address as "ADDRESS:PORT".
std::string to_text(const sockaddr_in& address);

/// The interface through which datagrams to the group leave this machine.
struct Interface {
  std::string name, address;
  bool is_loopback = false, can_multicast = false;
};

/// Returns nullopt if there is no route.
std::optional<Interface> interface_to(const sockaddr_in& group);

/// A UDP socket that is closed on destruction.
class Socket {
 public:
  /// @throws std::runtime_error if no socket can be made
  Socket();
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket();

  int get() const { return fd_; }

 private:
  int fd_;
};

}  // namespace quadrille::doctor

#include "link/datagram_guard.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <vector>

#include "contains.hpp"

namespace quadrille::bus {
namespace {

/// A UDP socket on a loopback address, of a port that the kernel chooses.
class LoopbackSocket {
 public:
  explicit LoopbackSocket(const char* address = "127.0.0.1") : fd_(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in own = {};
    own.sin_family = AF_INET;
    inet_pton(AF_INET, address, &own.sin_addr);
    REQUIRE(bind(fd_, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0);
  }
  LoopbackSocket(const LoopbackSocket&) = delete;
  LoopbackSocket& operator=(const LoopbackSocket&) = delete;
  ~LoopbackSocket() { close(fd_); }

  int get() const { return fd_; }
  sockaddr_in address() const {
    sockaddr_in own = {};
    socklen_t size = sizeof own;
    getsockname(fd_, reinterpret_cast<sockaddr*>(&own), &size);
    return own;
  }
  void send_to(const LoopbackSocket& other, const std::string& bytes) const {
    const sockaddr_in to = other.address();
    REQUIRE(sendto(fd_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to),
                   sizeof to) == static_cast<ssize_t>(bytes.size()));
  }
  /// What came first; a loopback datagram has come once it is sent.
  std::string receive() const {
    std::string bytes(1 << 16, '\0');
    const ssize_t got = recv(fd_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    bytes.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
    return bytes;
  }

 private:
  int fd_;
};

std::string big_endian(std::uint64_t value, int size) {
  std::string bytes;
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>(value >> shift & 0xff));
  }
  return bytes;
}

std::string fragment(std::uint64_t size, std::uint64_t offset, std::uint64_t number,
                     const std::string& rest) {
  return "LC03" + big_endian(7, 4) + big_endian(size, 4) + big_endian(offset, 4) +
         big_endian(number, 2) + big_endian(3, 2) + rest;
}

/// A name with its end, and some data.
std::string named(std::size_t length) { return std::string(length, 'A') + std::string(1, '\0'); }

/// Whether a guarded socket receives a datagram.
bool passes(const std::string& datagram) {
  const LoopbackSocket in, out;
  guard_socket(in.get(), {});
  out.send_to(in, datagram);
  const std::string got = in.receive();
  CHECK((got.empty() || got == datagram));
  return !got.empty();
}

TEST_CASE("what LCM sends passes the guard as it is", "[bus][guard]") {
  CHECK(passes("LC02" + big_endian(1, 4) + named(1) + "data"));
  CHECK(passes("LC02" + big_endian(1, 4) + named(63)));
  CHECK(passes(fragment(100'000, 0, 0, named(11) + std::string(40'000, 'x'))));
  CHECK(passes(fragment(100'000, 0, 0, named(63))));
  CHECK(passes(fragment(100'000, 40'000, 1, std::string(40'000, 'x'))));
  CHECK(passes(fragment(100'000, 100'000, 2, "")));
  CHECK(passes(fragment(std::uint64_t{1} << 28, (std::uint64_t{1} << 28) - 2, 2, "xx")));
}

TEST_CASE("datagrams that LCM dies of, or would not take, do not pass", "[bus][guard][hostile]") {
  // The sum of offset and size wraps in 32 bits.
  CHECK_FALSE(passes(fragment(100, 0xffffffff, 1, "xx")));
  CHECK_FALSE(passes(fragment(100, 101, 1, "xx")));
  CHECK_FALSE(passes(fragment(0xffffffff, 0xfffffffe, 1, "xx")));
  CHECK_FALSE(passes(fragment((std::uint64_t{1} << 28) + 1, 0, 0, named(1))));
  // The size of what follows the name wraps where the name has no end.
  CHECK_FALSE(passes(fragment(100, 0, 0, "POINT_CLOUD")));
  CHECK_FALSE(passes(fragment(100, 0, 0, named(64))));
  CHECK_FALSE(passes(fragment(100, 1, 0, named(1))));
  CHECK_FALSE(passes("LC02" + big_endian(1, 4) + "POINT_CLOUD"));
  CHECK_FALSE(passes("LC02" + big_endian(1, 4) + named(64)));
  const std::string whole = fragment(100, 4, 1, "");
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_FALSE(passes(whole.substr(0, size)));
  CHECK_FALSE(passes("LC04" + big_endian(1, 4) + named(1)));
}

TEST_CASE("this machine is always let in, whoever else is", "[bus][guard]") {
  const std::string datagram = "LC02" + big_endian(1, 4) + named(1);
  for (const char* senders : {"local", "10.9.8.7", "lo", "10.0.0.0/8,lo"}) {
    CAPTURE(senders);
    const LoopbackSocket in, out;
    guard_socket(in.get(), parse_senders(senders));
    out.send_to(in, datagram);
    CHECK(in.receive() == datagram);
  }
  const LoopbackSocket in;
  CHECK_THROWS_WITH(guard_socket(in.get(), parse_senders("nosuch0")),
                    test::contains("no interface 'nosuch0'"));
}

TEST_CASE("senders are addresses, networks and interfaces, and nothing else", "[bus][guard]") {
  CHECK(parse_senders("").all);
  CHECK_FALSE(parse_senders("local").all);
  const AcceptedSenders some = parse_senders("10.0.0.5,192.168.7.9/24,eth1,0.0.0.0/0");
  REQUIRE(some.networks.size() == 3);
  CHECK(some.networks[0].address == 0x0a000005);
  CHECK(some.networks[0].mask == 0xffffffff);
  CHECK(some.networks[1].address == 0xc0a80700);
  CHECK(some.networks[1].mask == 0xffffff00);
  CHECK(some.networks[2].mask == 0);
  CHECK(some.interfaces == std::vector<std::string>{"eth1"});
  for (const char* bad : {",", "10.0.0.5,", "10.0.0", "10.0.0.0/33", "10.0.0.0/", "10.0.0.0/-1",
                          "a b", "1eth", "averyverylonginterface"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(parse_senders(bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace quadrille::bus

#include "quadrille/bus/network.hpp"

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("a receive buffer too small is told with the command that mends it", "[bus][network]") {
  CHECK(find_buffer_problem(32 << 20, 4 << 20) == std::nullopt);
  const auto capped = find_buffer_problem(32 << 20, 212992);
  REQUIRE(capped);
  CHECK(capped->find("sudo sysctl -w net.core.rmem_max=33554432") != std::string::npos);
  const auto asked_too_little = find_buffer_problem(100000, 100000);
  REQUIRE(asked_too_little);
  CHECK(asked_too_little->find("recv_buf_size=33554432 in the LCM address") != std::string::npos);
}

TEST_CASE("the kernel grants what a small buffer asks for", "[bus][network]") {
  CHECK(granted_receive_buffer(65536) == 65536);
}

TEST_CASE("only a udpm address needs a route, and it has to be one", "[bus][network]") {
  CHECK(find_route_problem(parse_url("memq://")) == std::nullopt);
  CHECK(find_route_problem(parse_url("tcpq://127.0.0.1:7700")) == std::nullopt);
  CHECK_THROWS_AS(find_route_problem(parse_url("udpm://nowhere")), std::invalid_argument);
  CHECK_THROWS_AS(find_route_problem(parse_url("udpm://239.255.76.67:70000")),
                  std::invalid_argument);
}

TEST_CASE("dropped datagrams are counted from the start of the machine", "[bus][network]") {
  const std::int64_t before = count_dropped_datagrams();
  // Linux tells in /proc/net/snmp.
  CHECK(before >= 0);
  CHECK(count_dropped_datagrams() >= before);
}

}  // namespace
}  // namespace quadrille::bus

#include "link/drop_causes.hpp"

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

void check(const Drops& drops, std::int64_t buffer, std::int64_t filtered, std::int64_t unclear) {
  CHECK(drops.buffer == buffer);
  CHECK(drops.filtered == filtered);
  CHECK(drops.unclear == unclear);
}

TEST_CASE("datagrams dropped while no buffer was full were filtered", "[bus][network]") {
  DropCauses causes(UdpErrors{100, 50}, 0);
  causes.update(UdpErrors{100, 50}, 7, UdpErrors{107, 50});
  check(causes.drops(), 0, 7, 0);
  // Another socket's filter refused some too.
  causes.update(UdpErrors{107, 50}, 9, UdpErrors{150, 50});
  check(causes.drops(), 0, 9, 0);
}

TEST_CASE("datagrams dropped while nothing was filtered had no room", "[bus][network]") {
  DropCauses causes(UdpErrors{100, 50}, 0);
  causes.update(UdpErrors{100, 50}, 7, UdpErrors{107, 57});
  causes.update(UdpErrors{107, 57}, 7, UdpErrors{140, 90});
  check(causes.drops(), 7, 0, 0);
}

TEST_CASE("one socket alone has its causes told apart even at once", "[bus][network]") {
  DropCauses causes(UdpErrors{0, 0}, 0);
  causes.update(UdpErrors{0, 0}, 10, UdpErrors{10, 4});
  check(causes.drops(), 4, 6, 0);
}

TEST_CASE("what others drop at once makes the cause unclear, not wrong", "[bus][network]") {
  DropCauses causes(UdpErrors{0, 0}, 0);
  // This one: 10, of which 6 to 10 lacked room, for no more than 4 were filtered anywhere.
  causes.update(UdpErrors{0, 0}, 10, UdpErrors{24, 20});
  check(causes.drops(), 6, 0, 4);
}

TEST_CASE("what happens between two readings is of the one before as well", "[bus][network]") {
  DropCauses causes(UdpErrors{0, 0}, 0);
  // Three were dropped after the errors were read, and before the socket was.
  causes.update(UdpErrors{0, 0}, 3, UdpErrors{3, 0});
  // Two were dropped after the socket was read: they come with the next.
  causes.update(UdpErrors{5, 0}, 5, UdpErrors{5, 0});
  check(causes.drops(), 0, 5, 0);
}

TEST_CASE("where the system does not tell, nothing is claimed", "[bus][network]") {
  DropCauses causes(std::nullopt, 0);
  causes.update(std::nullopt, 5, UdpErrors{5, 5});
  causes.update(UdpErrors{5, 5}, 8, std::nullopt);
  // Counts that cannot be.
  causes.update(UdpErrors{5, 5}, 9, UdpErrors{5, 5});
  check(causes.drops(), 0, 0, 9);
}

TEST_CASE("the kernel counts in 32 bits", "[bus][network]") {
  DropCauses causes(UdpErrors{0, 0}, 0xfffffffe);
  causes.update(UdpErrors{0, 0}, 3, UdpErrors{5, 0});
  check(causes.drops(), 0, 5, 0);
}

TEST_CASE("this system tells its errors", "[bus][network]") {
  const auto errors = read_udp_errors();
  REQUIRE(errors);
  CHECK(errors->all >= errors->buffer);
}

}  // namespace
}  // namespace quadrille::bus

#include "link/network.hpp"

#include "contains.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("a receive buffer is judged by the messages that come", "[bus][network]") {
  constexpr int kStock = 212992;
  constexpr std::int64_t kLarge = 100 << 20;
  // Two fit, and no more: one waits while another is read.
  CHECK(find_buffer_problem(kStock, kStock, kStock / 2) == std::nullopt);
  CHECK(find_buffer_problem(kStock, kStock, kStock / 2 + 1));
  // 4 MiB, which once was taken for enough, hold no cloud of 8.6 MB.
  CHECK(find_buffer_problem(kMaxReceiveBufferBytes, 4 << 20, 8600000));
  CHECK(advised_receive_buffer(58000) == kReceiveBufferBytes);
  // One number for all usual clouds, whoever gives the advice.
  CHECK(advised_receive_buffer(kUsualCloudBytes) == kReceiveBufferBytes);
  CHECK(advised_receive_buffer(8600000) >= 8 * 8600000);
  CHECK(advised_receive_buffer(kLarge) >= 8 * kLarge);
  CHECK(advised_receive_buffer(std::int64_t{1} << 60) == 1 << 30);
}

TEST_CASE("no loss is told of before a message came", "[bus][network]") {
  constexpr int kStock = 212992;
  const auto foreseen = foresee_buffer_problem(kMaxReceiveBufferBytes, kStock);
  REQUIRE(foreseen);
  CHECK(foreseen->find("would lose clouds of 4915200 bytes") != std::string::npos);
  CHECK(foreseen->find("will be lost") == std::string::npos);
  CHECK(foresee_buffer_problem(kMaxReceiveBufferBytes, kReceiveBufferBytes) == std::nullopt);
}

TEST_CASE("the cure for a small receive buffer fits what the address asks for", "[bus][network]") {
  // The kernel counts twice a buffer in an int: it grants a byte less than this at the most,
  // whatever net.core.rmem_max is.
  constexpr int kTooMuch = 1 << 30;
  const std::string kSysctl = "sudo sysctl -w net.core.rmem_max=1073741824";
  const std::string kAddress = "recv_buf_size=1073741824 in the LCM address";
  const auto says = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  REQUIRE(granted_receive_buffer(kTooMuch) < kTooMuch);
  CHECK(says(mend_receive_buffer(kTooMuch, kTooMuch), kSysctl));
  CHECK(!says(mend_receive_buffer(kTooMuch, kTooMuch), kAddress));
  CHECK(says(mend_receive_buffer(65536, kTooMuch), kSysctl));
  CHECK(says(mend_receive_buffer(65536, kTooMuch), kAddress));
  // What the kernel grants needs no other limit.
  CHECK(!says(mend_receive_buffer(4096, 65536), "sysctl"));
  CHECK(says(mend_receive_buffer(4096, 65536), "recv_buf_size=65536 in the LCM address"));
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
  // No route would help.
  CHECK_THROWS_WITH(find_route_problem(parse_url("udpm://10.0.0.1:7667")),
                    test::contains("10.0.0.1 is no multicast address"));
}

}  // namespace
}  // namespace quadrille::bus

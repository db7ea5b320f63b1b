#include "link/connection.hpp"

#include "contains.hpp"

namespace quadrille::bus {
namespace {

const std::vector<std::byte> kBytes(5, std::byte{1});

TEST_CASE("an address that does not work is an error and never another transport", "[bus]") {
  CHECK_THROWS_AS(Connection("udpm://nowhere"), std::invalid_argument);
  CHECK_THROWS_AS(Connection("udpm://239.255.76.67:99999"), std::invalid_argument);
  CHECK_THROWS_AS(Connection("pigeon://"), std::runtime_error);
  CHECK_THROWS_AS(Connection("file:///nonexistent/x.lcm"), std::runtime_error);
  // Nothing listens on the discard port.
  CHECK_THROWS_WITH(Connection("tcpq://127.0.0.1:9"), test::contains("lcm-tcpq-server"));
}

TEST_CASE("a receive buffer's size is a number of bytes and nothing else", "[bus][hostile]") {
  for (const char* size : {"big", "", "0", "-1", "33554432x", "3.5", "99999999999999999999"}) {
    CAPTURE(size);
    const Url url = parse_url("udpm://239.255.76.67:7667?recv_buf_size=" + std::string(size));
    CHECK_THROWS_WITH(named_receive_buffer(url),
                      test::contains("recv_buf_size = '" + std::string(size) + "'"));
  }
}

TEST_CASE("only the channel of exactly that name reaches a handler", "[bus]") {
  Connection connection("memq://");
  std::vector<std::string> got, all;
  connection.subscribe("A.B", [&](const std::string& channel, auto) { got.push_back(channel); });
  connection.subscribe(ChannelPattern(".*"),
                       [&](const std::string& channel, auto) { all.push_back(channel); });
  connection.publish("AxB", kBytes);
  connection.publish("A.B", kBytes);
  while (connection.handle(0) == Connection::Outcome::kHandled) {
  }
  CHECK(got == std::vector<std::string>{"A.B"});
  CHECK(all == std::vector<std::string>{"AxB", "A.B"});
}

TEST_CASE("all channels that a pattern matches reach its handler", "[bus]") {
  Connection connection("memq://");
  std::vector<std::string> got;
  connection.subscribe(ChannelPattern("LEFT|CAMERA_.*"),
                       [&](const std::string& channel, auto) { got.push_back(channel); });
  for (const char* channel : {"CAMERA_1", "A_CAMERA_1", "LEFT", "LEFT_A", "CAMERA_2"}) {
    connection.publish(channel, kBytes);
  }
  while (connection.handle(0) == Connection::Outcome::kHandled) {
  }
  CHECK(got == std::vector<std::string>{"CAMERA_1", "LEFT", "CAMERA_2"});
}

TEST_CASE("names that LCM would misread are refused", "[bus]") {
  for (const char* name : {"", "A B", ".*", "A+", "(A"}) {
    CHECK_THROWS_AS(check_channel(name), std::invalid_argument);
  }
  CHECK_THROWS_AS(check_channel(std::string(64, 'A')), std::invalid_argument);
  CHECK_NOTHROW(check_channel(std::string(63, 'A')));
  CHECK_NOTHROW(check_channel("robot-1/POINT_CLOUD.left"));
}

TEST_CASE("what a handler throws passes around LCM, which goes on working", "[bus]") {
  Connection connection("memq://");
  int calls = 0;
  connection.subscribe("A", [&](const std::string&, std::span<const std::byte> bytes) {
    CHECK(bytes.size() == 5);
    if (++calls == 1) throw std::runtime_error("first");
  });
  connection.publish("A", kBytes);
  connection.publish("A", kBytes);
  CHECK_THROWS_WITH(connection.handle(1000), "first");
  CHECK(connection.handle(1000) == Connection::Outcome::kHandled);
  CHECK(connection.handle(0) == Connection::Outcome::kTimeout);
  CHECK(calls == 2);
}

}  // namespace
}  // namespace quadrille::bus

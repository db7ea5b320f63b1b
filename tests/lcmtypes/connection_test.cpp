#include "quadrille/bus/connection.hpp"

#include <cstdlib>

#include "contains.hpp"
#include "quadrille/bus/network.hpp"
#include "quadrille/bus/receiver.hpp"
#include "quadrille/bus/url.hpp"

namespace quadrille::bus {
namespace {

const std::vector<std::byte> kBytes(5, std::byte{1});

TEST_CASE("an address is taken apart and put together", "[bus][url]") {
  const Url url = parse_url("udpm://239.255.76.67:7667?ttl=1&recv_buf_size=4096");
  CHECK(url.provider == "udpm");
  CHECK(url.network == "239.255.76.67:7667");
  CHECK(url.arguments.at("ttl") == "1");
  CHECK(url.to_string() == "udpm://239.255.76.67:7667?recv_buf_size=4096&ttl=1");
  CHECK(parse_url("memq://").to_string() == "memq://");
  CHECK_THROWS_AS(parse_url("239.255.76.67:7667"), std::invalid_argument);
}

TEST_CASE("the option wins over the environment, and that over the default", "[bus][url]") {
  setenv("LCM_DEFAULT_URL", "memq://", 1);
  CHECK(resolve_url("tcpq://") == "tcpq://");
  CHECK(resolve_url("") == "memq://");
  setenv("LCM_DEFAULT_URL", "", 1);
  CHECK(resolve_url("") == "udpm://239.255.76.67:7667?ttl=0");
  unsetenv("LCM_DEFAULT_URL");
  CHECK(resolve_url("") == "udpm://239.255.76.67:7667?ttl=0");
}

TEST_CASE("a log that LCM could not open by address is refused", "[bus][url]") {
  CHECK(replay_url("a/b.lcm") == "file://a/b.lcm?speed=0");
  CHECK_THROWS_AS(replay_url("what?.lcm"), std::invalid_argument);
  CHECK_THROWS_AS(replay_url(""), std::invalid_argument);
}

TEST_CASE("an address that does not work is an error and never another transport", "[bus]") {
  CHECK_THROWS_AS(Connection("udpm://nowhere"), std::invalid_argument);
  CHECK_THROWS_AS(Connection("udpm://239.255.76.67:99999"), std::invalid_argument);
  CHECK_THROWS_AS(Connection("udpm://239.255.76.67:7667?recv_buf_size=big"), std::invalid_argument);
  CHECK_THROWS_AS(Connection("pigeon://"), std::runtime_error);
  CHECK_THROWS_AS(Connection("file:///nonexistent/x.lcm"), std::runtime_error);
  // Nothing listens on the discard port.
  CHECK_THROWS_WITH(Connection("tcpq://127.0.0.1:9"), test::contains("lcm-tcpq-server"));
}

TEST_CASE("only the channel of exactly that name reaches a handler", "[bus]") {
  Connection connection("memq://");
  std::vector<std::string> got, all;
  connection.subscribe("A.B", [&](const std::string& channel, auto) { got.push_back(channel); });
  connection.subscribe_all([&](const std::string& channel, auto) { all.push_back(channel); });
  connection.publish("AxB", kBytes);
  connection.publish("A.B", kBytes);
  while (connection.handle(0) == Connection::Outcome::kHandled) {
  }
  CHECK(got == std::vector<std::string>{"A.B"});
  CHECK(all == std::vector<std::string>{"AxB", "A.B"});
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

TEST_CASE("what ends the receiving thread is thrown where it is looked after", "[bus]") {
  Connection connection("memq://");
  connection.subscribe("A", [](const std::string&, auto) { throw std::runtime_error("broken"); });
  Receiver receiver(connection);
  CHECK_NOTHROW(receiver.check());
  connection.publish("A", kBytes);
  std::string what;
  for (int i = 0; i < 1000 && what.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    try {
      receiver.check();
    } catch (const std::runtime_error& error) {
      what = error.what();
    }
  }
  CHECK(what == "broken");
}

}  // namespace
}  // namespace quadrille::bus

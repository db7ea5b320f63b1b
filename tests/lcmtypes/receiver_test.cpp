#include "link/receiver.hpp"

#include <chrono>
#include <stdexcept>

#include "contains.hpp"
#include "support/catch.hpp"
#include "support/tcpq_server.hpp"

namespace quadrille::bus {
namespace {

const std::vector<std::byte> kReceived(5, std::byte{1});

TEST_CASE("what ends the receiving thread is thrown where it is looked after", "[bus]") {
  Connection connection("memq://");
  connection.subscribe("A", [](const std::string&, auto) { throw std::runtime_error("broken"); });
  Receiver receiver(connection);
  CHECK_NOTHROW(receiver.check());
  connection.publish("A", kReceived);
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

TEST_CASE("messages are handled in another thread until the receiver goes", "[bus]") {
  Connection connection("memq://");
  std::atomic<int> calls{0};
  std::thread::id thread;
  connection.subscribe("A", [&](const std::string&, auto) {
    thread = std::this_thread::get_id();
    ++calls;
  });
  {
    const Receiver receiver(connection);
    connection.publish("A", kReceived);
    for (int i = 0; i < 1000 && calls == 0; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  CHECK(calls == 1);
  CHECK(thread != std::this_thread::get_id());
  connection.publish("A", kReceived);
  CHECK(calls == 1);
}

TEST_CASE("a connection whose server is gone is lost", "[bus]") {
  const test::TcpqServer server;
  Connection connection(server.url());
  EndlessHandler handler(connection);
  CHECK_THROWS_WITH(
      [&] {
        for (int tries = 0; tries < 2000; ++tries) handler.handle(10);
      }(),
      test::contains("the connection is lost"));
}

}  // namespace
}  // namespace quadrille::bus

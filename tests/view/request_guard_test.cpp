#include "view/http/request_guard.hpp"

#include "support/catch.hpp"

using quadrille::view::RequestGuard;

TEST_CASE("on the loopback address only requests that name this machine are taken",
          "[view][safety]") {
  const RequestGuard guard("127.0.0.1");
  for (const char* host : {"127.0.0.1", "127.0.0.1:8765", "localhost:1", "[::1]:8765", "[::1]"}) {
    CAPTURE(host);
    CHECK(guard.allows_host(host));
  }
  for (const char* host :
       {"", "evil.example", "evil.example:8765", "127.0.0.1.evil.example", "localhost.evil.example",
        "192.168.1.7:8765", "[::1", "127.0.0.1:", "127.0.0.1:80x", "localhost:80:80", "127.evil",
        "[::1]x:80", "LOCALHOST@evil.example"}) {
    CAPTURE(host);
    CHECK(!guard.allows_host(host));
  }
}

TEST_CASE("only the page itself may ask", "[view][safety]") {
  const RequestGuard guard("127.0.0.1");
  CHECK(guard.allows_origin("", "127.0.0.1:8765"));
  CHECK(guard.allows_origin("http://127.0.0.1:8765", "127.0.0.1:8765"));
  for (const char* origin :
       {"http://evil.example", "null", "https://127.0.0.1:8765", "http://127.0.0.1:9999",
        "http://localhost:8765", "http://127.0.0.1:8765.evil.example"}) {
    CAPTURE(origin);
    CHECK(!guard.allows_origin(origin, "127.0.0.1:8765"));
  }
  CHECK(!guard.allows_origin("http://evil.example", "evil.example"));
}

TEST_CASE("bound to the network, it is reached by numbers and never by names", "[view][safety]") {
  const RequestGuard guard("0.0.0.0");
  CHECK(guard.allows_host("192.168.1.7:8765"));
  CHECK(guard.allows_host("[fe80::1]:8765"));
  CHECK(!guard.allows_host("robot.example:8765"));
}

#include "link/url.hpp"

#include <cstdlib>

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

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

}  // namespace
}  // namespace quadrille::bus

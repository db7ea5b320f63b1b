#include "quadrille/bus/encode.hpp"

#include <lcmtypes/quadrille/count_t.hpp>

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("a message is encoded to the bytes that its type decodes", "[bus][encode]") {
  count_t message;
  message.name = "bad_length";
  message.count = 7;
  const std::vector<std::byte> bytes = encode(message);
  // Fingerprint, length and letters of the name with their zero, count.
  CHECK(bytes.size() == 8 + 4 + 11 + 8);
  count_t got;
  const int size = static_cast<int>(bytes.size());
  REQUIRE(got.decode(bytes.data(), 0, size) == size);
  CHECK(got.name == "bad_length");
  CHECK(got.count == 7);
}

}  // namespace
}  // namespace quadrille::bus

#include "quadrille/bus/request_message.hpp"

#include "quadrille/bus/encode.hpp"
#include "samples.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

grasp_request_t some_request() {
  grasp_request_t m{};
  m.request_id = 7;
  m.cloud_utime = 1234;
  m.frame = "world";
  m.targets = {3, 5};
  m.num_targets = 2;
  m.tracks = {9};
  m.num_tracks = 1;
  m.types = {"sphere", "cone"};
  m.num_types = 2;
  m.max_grasps = 4;
  m.min_size = 0.25;
  return m;
}

RejectReason reason(const std::vector<std::byte>& bytes) {
  return std::get<Rejection>(decode_request(bytes)).reason;
}

}  // namespace

TEST_CASE("a request survives its message", "[bus][request]") {
  const auto decoded = decode_request(encode(some_request()));
  REQUIRE(std::holds_alternative<grasp_request_t>(decoded));
  const auto& got = std::get<grasp_request_t>(decoded);
  CHECK(got.request_id == 7);
  CHECK(got.cloud_utime == 1234);
  CHECK(got.frame == "world");
  CHECK(got.targets == std::vector{3, 5});
  CHECK(got.types == std::vector<std::string>{"sphere", "cone"});
  CHECK(got.min_size == 0.25);
  CHECK(got.max_grasps == 4);
  grasp_request_t plain{};
  CHECK(reason(encode(plain)) == RejectReason::kBadValue);
  plain.request_id = -1;
  CHECK(std::holds_alternative<grasp_request_t>(decode_request(encode(plain))));
}

TEST_CASE("a request cut short anywhere, or with bytes behind it, is refused", "[bus][hostile]") {
  std::vector<std::byte> bytes = encode(some_request());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK(std::holds_alternative<Rejection>(decode_request(std::span(bytes).first(size))));
  }
  bytes.push_back(std::byte{0});
  CHECK(reason(bytes) == RejectReason::kTrailingBytes);
  CHECK(reason(test::make_quadrics_bytes()) == RejectReason::kUnknownType);
  CHECK(reason(std::vector<std::byte>(kMaxRequestBytes + 1)) == RejectReason::kTooLarge);
}

TEST_CASE("a request with more ids than bytes is refused", "[bus][hostile]") {
  std::vector<std::byte> bytes = encode(some_request());
  // num_targets: after the fingerprint, three times and "world" with its length and end mark.
  const std::size_t at = 8 + 3 * 8 + 4 + 6;
  CHECK(bytes[at + 3] == std::byte{2});
  bytes[at] = std::byte{0x7f};
  CHECK(std::holds_alternative<Rejection>(decode_request(bytes)));
}

}  // namespace quadrille::bus

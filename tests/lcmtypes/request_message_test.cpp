#include "quadrille/bus/request_message.hpp"

#include "grasp_samples.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

RejectReason reason(const std::vector<std::byte>& bytes) {
  return std::get<Rejection>(decode_request(bytes)).reason;
}

}  // namespace

TEST_CASE("a request survives its message", "[bus][request]") {
  const auto decoded = decode_request(encode(test::make_request()));
  REQUIRE(std::holds_alternative<grasp_request_t>(decoded));
  const auto& got = std::get<grasp_request_t>(decoded);
  CHECK(got.request_id == 7);
  CHECK(got.cloud_utime == 1234);
  CHECK(got.frame == "world");
  CHECK(got.targets == std::vector{3, 5});
  CHECK(got.types == std::vector<std::string>{"sphere", "cone"});
  CHECK(got.min_size == 0.25);
  CHECK(got.has_reach == 1);
  CHECK(got.reach_base[2] == -0.5);
  CHECK(got.reach_max == 0.85);
  CHECK(got.min_score == 0.75);
  CHECK(got.per_target == 3);
  CHECK(got.max_grasps == 4);
  CHECK(got.advise == 1);
  grasp_request_t plain{};
  CHECK(reason(encode(plain)) == RejectReason::kBadValue);
  plain.request_id = -1;
  CHECK(std::holds_alternative<grasp_request_t>(decode_request(encode(plain))));
}

TEST_CASE("a request with more ids than bytes is refused", "[bus][hostile]") {
  std::vector<std::byte> bytes = encode(test::make_request());
  // num_targets: after the fingerprint, three times and "world" with its length and end mark.
  const std::size_t at = 8 + 3 * 8 + 4 + 6;
  CHECK(bytes[at + 3] == std::byte{2});
  bytes[at] = std::byte{0x7f};
  CHECK(std::holds_alternative<Rejection>(decode_request(bytes)));
}

}  // namespace quadrille::bus

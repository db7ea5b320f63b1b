#include "quadrille/bus/shard_message.hpp"

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "samples.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

shard_cloud_t make_shard_cloud() {
  shard_cloud_t message{};
  message.utime = 1234567;
  message.seq = -3;
  message.message_digest = -5;
  message.cloud_digest = 1ll << 62;
  message.shard = 2;
  message.shards = 3;
  message.sender = 9;
  return message;
}

TEST_CASE("what a shard tells of a cloud comes as it was sent", "[bus][shard]") {
  const auto decoded = decode_shard_cloud(encode(make_shard_cloud()));
  REQUIRE(std::holds_alternative<shard_cloud_t>(decoded));
  CHECK(encode(std::get<shard_cloud_t>(decoded)) == encode(make_shard_cloud()));
}

TEST_CASE("what no shard sends is refused", "[bus][shard][hostile]") {
  auto bytes = encode(make_shard_cloud());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK(std::holds_alternative<Rejection>(decode_shard_cloud({bytes.data(), size})));
  }
  bytes.push_back(std::byte{0});
  CHECK(std::holds_alternative<Rejection>(decode_shard_cloud(bytes)));
  for (const auto& [shard, shards] : {std::pair{0, 2}, {3, 2}, {-1, -1}}) {
    shard_cloud_t message = make_shard_cloud();
    message.shard = shard;
    message.shards = shards;
    CHECK(std::holds_alternative<Rejection>(decode_shard_cloud(encode(message))));
  }
}

TEST_CASE("the beginning of a cloud's message tells its time and number", "[bus][cloud]") {
  for (const CloudFormat format : all_cloud_formats()) {
    CloudMessage cloud = test::make_cloud();
    cloud.utime = 42;
    cloud.seq = 7;
    auto bytes = encode_cloud(cloud, format);
    const auto stamp = read_stamp(bytes);
    REQUIRE(stamp);
    CHECK(stamp->utime == 42);
    CHECK(stamp->seq == (format == CloudFormat::kDrake ? 0 : 7));
    CHECK_FALSE(read_stamp({bytes.data(), 15}));
    bytes[0] ^= std::byte{1};
    CHECK_FALSE(read_stamp(bytes));
  }
}

}  // namespace
}  // namespace quadrille::bus

#include "cloud_samples.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

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

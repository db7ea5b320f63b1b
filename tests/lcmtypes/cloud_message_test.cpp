#include "cloud_samples.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

CloudMessage decode_or_fail(const std::vector<std::byte>& bytes) {
  auto decoded = decode_cloud(bytes);
  if (const auto* rejection = std::get_if<Rejection>(&decoded)) FAIL(rejection->detail);
  return std::get<CloudMessage>(std::move(decoded));
}

bool same_points(const PointCloud& a, const PointCloud& b) {
  if (a.points.size() != b.points.size()) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const bool missing = !a.points[i].allFinite();
    if (missing != !b.points[i].allFinite() || (!missing && a.points[i] != b.points[i])) {
      return false;
    }
  }
  return true;
}

TEST_CASE("an organised cloud survives the message types that know rows", "[bus][cloud]") {
  const auto format = GENERATE(CloudFormat::kDrake, CloudFormat::kPointCloud2);
  const CloudMessage sent = test::make_cloud();
  const CloudMessage got = decode_or_fail(encode_cloud(sent, format));
  CHECK(got.utime == sent.utime);
  CHECK(got.seq == (format == CloudFormat::kDrake ? 0 : sent.seq));
  CHECK(got.cloud.frame == "camera");
  CHECK(got.cloud.width == 4);
  CHECK(got.cloud.height == 3);
  CHECK(got.cloud.read == 12);
  CHECK(same_points(got.cloud, sent.cloud));
}

TEST_CASE("an unorganised cloud survives all message types, with the number of points announced",
          "[bus][cloud]") {
  const auto format =
      GENERATE(CloudFormat::kDrake, CloudFormat::kPointCloud2, CloudFormat::kPointCloud);
  const CloudMessage sent = test::make_unorganised_cloud();
  const CloudMessage got = decode_or_fail(encode_cloud(sent, format));
  CHECK(got.utime == sent.utime);
  CHECK_FALSE(got.cloud.organised());
  CHECK(got.cloud.points.size() == 10);
  CHECK(got.cloud.read == 12);
  CHECK(same_points(got.cloud, sent.cloud));
}

TEST_CASE("coordinates are found as float64 at any offset and in either byte order",
          "[bus][cloud]") {
  const bool big_endian = GENERATE(false, true);
  const CloudMessage got = decode_or_fail(encode(test::make_wide_message(big_endian)));
  REQUIRE(got.cloud.points.size() == 2);
  CHECK(got.cloud.points[0] == Eigen::Vector3f(2.5f, 3.5f, 0.5f));
  CHECK(got.cloud.points[1] == Eigen::Vector3f(12.5f, 13.5f, 10.5f));
}

TEST_CASE("a cloud in another unit is converted when it is read", "[bus][cloud]") {
  CloudMessage sent = test::make_cloud();
  for (Eigen::Vector3f& p : sent.cloud.points) p *= 1000.0f;
  const auto format = GENERATE(CloudFormat::kDrake, CloudFormat::kPointCloud2);
  const auto decoded =
      decode_cloud(encode_cloud(sent, format), kMaxMessageBytes, CloudColours::kDrop, 1e-3);
  const PointCloud& got = std::get<CloudMessage>(decoded).cloud;
  REQUIRE(got.points.size() == 12);
  for (std::size_t i = 0; i < got.points.size(); ++i) {
    const Eigen::Vector3f& p = sent.cloud.points[i];
    CHECK(got.points[i].allFinite() == p.allFinite());
    if (p.allFinite()) CHECK((got.points[i] - 1e-3f * p).norm() < 1e-6f);
  }
}

TEST_CASE("rows may be padded", "[bus][cloud]") {
  auto m = test::make_wide_message(false);
  m.width = 1;
  m.height = 2;
  m.row_step = 40;
  m.data.insert(m.data.begin() + 33, 7, std::uint8_t{0xaa});
  m.data_size = static_cast<std::int64_t>(m.data.size());
  const CloudMessage got = decode_or_fail(encode(m));
  REQUIRE(got.cloud.points.size() == 2);
  CHECK(got.cloud.points[1] == Eigen::Vector3f(12.5f, 13.5f, 10.5f));
}

TEST_CASE("a cloud without points is valid", "[bus][cloud]") {
  const auto format =
      GENERATE(CloudFormat::kDrake, CloudFormat::kPointCloud2, CloudFormat::kPointCloud);
  CHECK(decode_or_fail(encode_cloud({}, format)).cloud.points.empty());
  auto m = test::make_wide_message(false);
  m.width = 0;
  m.height = std::int64_t{1} << 60;
  CHECK(decode_or_fail(encode(m)).cloud.points.empty());
}

TEST_CASE("a cloud that contradicts itself is not encoded", "[bus][cloud]") {
  CloudMessage message = test::make_cloud();
  message.cloud.width = 5;
  CHECK_THROWS_AS(encode_cloud(message, CloudFormat::kDrake), std::invalid_argument);
  message = test::make_cloud();
  message.cloud.frame.assign(kMaxFrameBytes + 1, 'f');
  CHECK_THROWS_AS(encode_cloud(message, CloudFormat::kDrake), std::invalid_argument);
}

TEST_CASE("the digest of a cloud is that of its points, whatever its stamps and message type",
          "[bus][cloud]") {
  const CloudMessage sent = test::make_unorganised_cloud();
  const std::int64_t digest = decode_or_fail(encode_cloud(sent, CloudFormat::kDrake)).digest;
  CHECK(digest != 0);
  CloudMessage later = sent;
  later.utime += 1;
  later.seq += 1;
  for (const CloudFormat format : all_cloud_formats()) {
    CHECK(decode_or_fail(encode_cloud(later, format)).digest == digest);
  }
  CloudMessage other = sent;
  other.cloud.points[3].x() = std::nextafter(other.cloud.points[3].x(), 9.0f);
  CHECK(digest_of(other.cloud) != digest);
  other = sent;
  std::swap(other.cloud.points[0], other.cloud.points[1]);
  CHECK(digest_of(other.cloud) != digest);
  PointCloud turned = test::make_cloud().cloud;
  std::swap(turned.width, turned.height);
  CHECK(digest_of(turned) != digest_of(test::make_cloud().cloud));
  CHECK(digest_of(PointCloud()) != 0);
}

TEST_CASE("each format has its name", "[bus][cloud]") {
  std::vector<std::string> names;
  for (const CloudFormat format : all_cloud_formats()) names.emplace_back(to_string(format));
  CHECK(names == std::vector<std::string>{"drake", "pointcloud2", "pointcloud"});
}

}  // namespace
}  // namespace quadrille::bus

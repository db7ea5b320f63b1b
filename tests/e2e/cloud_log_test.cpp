#include <filesystem>

#include "logs/cloud_log_reader.hpp"
#include "logs/cloud_log_writer.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::logs {
namespace {

namespace fs = std::filesystem;

std::vector<PointCloud> make_clouds() {
  std::vector<PointCloud> clouds(3);
  for (int i = 0; i < 3; ++i) {
    clouds[static_cast<std::size_t>(i)].frame = "camera";
    clouds[static_cast<std::size_t>(i)].points = {{1.0f, 2.0f, 3.0f + i}, {4, 5, 6}};
  }
  return clouds;
}

void write_log(const std::string& path, const CloudLogOptions& options) {
  CloudLogWriter writer(path, options);
  for (const PointCloud& cloud : make_clouds()) writer.write(cloud);
}

TEST_CASE("clouds come out of a log as they went in, at the rate asked for", "[logs]") {
  const test::TempFolder folder;
  const auto format = GENERATE(bus::CloudFormat::kDrake, bus::CloudFormat::kPointCloud2,
                               bus::CloudFormat::kPointCloud);
  CloudLogOptions options;
  options.rate = 30.0;
  options.channel = "LIDAR";
  options.format = format;
  write_log(folder.path("x.lcm"), options);
  CloudLogReader reader(folder.path("x.lcm"), "LIDAR");
  const std::int64_t utimes[] = {33333, 66667, 100000};
  for (int i = 0; i < 3; ++i) {
    const auto got = reader.next();
    REQUIRE(got);
    CHECK(got->channel == "LIDAR");
    CHECK(got->event_utime == utimes[i]);
    CHECK(got->message.utime == utimes[i]);
    CHECK(got->message.cloud.frame == "camera");
    REQUIRE(got->message.cloud.points.size() == 2);
    CHECK(got->message.cloud.points[0].z() == 3.0f + i);
  }
  CHECK_FALSE(reader.next());
  CHECK(reader.rejected().total() == 0);
  CHECK_FALSE(CloudLogReader(folder.path("x.lcm"), "POINT_CLOUD").next());
}

TEST_CASE("events that are no valid clouds are counted, other types passed over",
          "[logs][hostile]") {
  const test::TempFolder folder;
  const std::vector<std::byte> good =
      bus::encode_cloud({1, 0, make_clouds()[0]}, bus::CloudFormat::kDrake);
  std::vector<std::byte> long_one = good;
  long_one.push_back(std::byte{0});
  {
    bus::LogWriter log(folder.path("x.lcm"));
    log.write(1, "POSE", std::vector<std::byte>(20));
    log.write(2, "POINT_CLOUD", long_one);
    log.write(3, "POINT_CLOUD", std::vector<std::byte>(20));
    log.write(4, "POINT_CLOUD", good);
  }
  CloudLogReader any(folder.path("x.lcm"));
  CHECK(any.next());
  CHECK_FALSE(any.next());
  CHECK(any.rejected().total() == 1);
  CloudLogReader named(folder.path("x.lcm"), "POINT_CLOUD");
  CHECK(named.next());
  CHECK_FALSE(named.next());
  CHECK(named.rejected().of(bus::RejectReason::kTrailingBytes) == 1);
  CHECK(named.rejected().of(bus::RejectReason::kUnknownType) == 1);
}

TEST_CASE("a log cut short gives its whole clouds and tells where it ends", "[logs][hostile]") {
  const test::TempFolder folder;
  write_log(folder.path("x.lcm"), {});
  fs::resize_file(folder.path("x.lcm"), fs::file_size(folder.path("x.lcm")) - 5);
  CloudLogReader reader(folder.path("x.lcm"));
  CHECK(reader.next());
  CHECK(reader.next());
  CHECK_FALSE(reader.next());
  REQUIRE(reader.defect());
  CHECK(reader.defect()->starts_with("cut short at byte "));
}

TEST_CASE("options out of range are refused", "[logs]") {
  CloudLogOptions options;
  options.rate = 0.0;
  CHECK_THROWS_AS(options.check(), std::invalid_argument);
  options.rate = 10.0;
  options.channel = "A B";
  CHECK_THROWS_AS(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace quadrille::logs

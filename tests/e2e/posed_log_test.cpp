#include <map>
#include <variant>

#include "logs/posed_log_writer.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::logs {
namespace {

/// A camera that moves along x by a metre a second.
Eigen::Isometry3d pose_at(double time) {
  return Eigen::Isometry3d(Eigen::Translation3d(time, 0.0, 0.0));
}

PointCloud one_point() {
  PointCloud cloud;
  cloud.points = {{1.0f, 2.0f, 3.0f}};
  cloud.read = 1;
  return cloud;
}

TEST_CASE("clouds come with the poses around them, in the order of their times", "[logs][pose]") {
  const test::TempFolder folder;
  CloudLogOptions options;
  options.rate = GENERATE(100.0, 30.0, 7.0);
  constexpr int kClouds = 5;
  PosedLogWriter writer(folder.path("x.lcm"), options, "POSE", pose_at);
  for (int i = 0; i < kClouds; ++i) writer.write(one_point());
  writer.finish();

  bus::LogReader reader(folder.path("x.lcm"));
  const std::int64_t start = options.utime_of(1);
  std::int64_t last = -1, last_pose = -1, last_cloud = -1;
  std::map<std::string, int> events;
  while (const auto event = reader.next()) {
    CHECK(event->utime >= last);
    last = event->utime;
    if (++events[event->channel]; event->channel == "POSE") {
      const auto decoded = bus::decode_pose(event->bytes);
      REQUIRE(std::holds_alternative<bus::PoseMessage>(decoded));
      const auto& pose = std::get<bus::PoseMessage>(decoded);
      CHECK(pose.utime == event->utime);
      const double time = 1e-6 * static_cast<double>(pose.utime - start);
      CHECK(pose.X_WC.translation().x() == Approx(time).margin(1e-12));
      CHECK(pose.utime - (last_pose < 0 ? start - 15'000 : last_pose) == 10'000);
      last_pose = pose.utime;
    } else {
      last_cloud = event->utime;
      CHECK(last_cloud == options.utime_of(events["POINT_CLOUD"]));
      CHECK(last_cloud - last_pose < 10'000);
    }
  }
  CHECK(events["POINT_CLOUD"] == kClouds);
  CHECK(last_pose > last_cloud);
  CHECK(last_pose <= last_cloud + 10'000);
}

TEST_CASE("clouds that come faster than poses are refused", "[logs][pose]") {
  const test::TempFolder folder;
  CloudLogOptions options;
  options.rate = 101.0;
  CHECK_THROWS_AS(PosedLogWriter(folder.path("x.lcm"), options, "POSE", pose_at),
                  std::invalid_argument);
  options.rate = 30.0;
  CHECK_THROWS_AS(PosedLogWriter(folder.path("x.lcm"), options, "A B", pose_at),
                  std::invalid_argument);
}

}  // namespace
}  // namespace quadrille::logs

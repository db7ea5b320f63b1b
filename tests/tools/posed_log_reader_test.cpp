#include "logs/posed_log_reader.hpp"

#include <optional>
#include <string>
#include <vector>

#include "log/event_log.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/pose_message.hpp"
#include "support/catch.hpp"
#include "support/robot_log.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

constexpr std::int64_t kMilli = 1000;

/// Events of a log: clouds with one point, and poses of a camera that moves by a metre a second.
class PosedLog {
 public:
  void cloud(std::int64_t utime, std::int64_t at) {
    PointCloud cloud;
    cloud.points = {{1.0f, 2.0f, 3.0f}};
    log_.write(at, "POINT_CLOUD", bus::encode_cloud({utime, 0, cloud}, bus::CloudFormat::kDrake));
  }
  void pose(std::int64_t utime, std::int64_t at) {
    const double x = 1e-6 * static_cast<double>(utime);
    log_.write(at, "POSE",
               bus::encode_pose({utime, Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0))}));
  }
  /// The places of the clouds' cameras [m]; -1 if one is not known.
  std::vector<double> places(const std::string& pose_channel = "POSE", double wait = 0.05) {
    log_.flush();
    logs::PosedLogReader reader(path_, "", pose_channel, 1.0, wait);
    std::vector<double> places;
    std::int64_t last = -1;
    while (const auto cloud = reader.next()) {
      CHECK(cloud->cloud.message.utime > last);
      last = cloud->cloud.message.utime;
      CHECK(cloud->pose.X_WK.has_value() != !cloud->pose.detail.empty());
      places.push_back(cloud->pose.X_WK ? cloud->pose.X_WK->translation().x() : -1.0);
    }
    return places;
  }

 private:
  const test::TempFolder folder_;
  const std::string path_ = folder_.path("x.lcm");
  bus::LogWriter log_{path_};
};

TEST_CASE("a cloud of a log gets the robot's shapes that are nearest in time", "[logs][robot]") {
  const test::TempFolder folder;
  const std::string path = folder.path("r.lcm");
  {
    test::RobotLog log(path);
    log.show(1 * kMilli);
    log.tell(2 * kMilli, 0.02);
    log.tell(9 * kMilli, 0.09);
    log.show(4 * kMilli);
    log.show(10 * kMilli);
  }
  const auto paddings = [&](const std::string& channel) {
    logs::PosedLogReader reader(path, "", "", 1.0, 0.05, 1.0, channel);
    std::vector<double> found;
    while (const auto cloud = reader.next()) {
      found.push_back(cloud->robot ? cloud->robot->robot.padding : -1.0);
    }
    return found;
  };
  CHECK(paddings("ROBOT") == std::vector<double>{-1.0, 0.02, 0.09});
  CHECK(paddings("") == std::vector<double>{-1.0, -1.0, -1.0});
}

TEST_CASE("messages on the robot of a log that are refused are counted", "[logs][robot][hostile]") {
  const test::TempFolder folder;
  const std::string path = folder.path("bad.lcm");
  {
    test::RobotLog log(path);
    log.tell_nonsense(1, 20);
    log.tell(2, 0.0);
    log.tell_nonsense(3, 3);
  }
  logs::PosedLogReader reader(path, "", "", 1.0, 0.05, 1.0, "ROBOT");
  CHECK(!reader.next());
  CHECK(reader.robot_refusals().count == 2);
  CHECK(!reader.robot_refusals().why_first.empty());
}

TEST_CASE("the clouds of a log get the poses around them", "[logs][pose]") {
  PosedLog log;
  for (int n = 0; n <= 10; ++n) log.pose(n * 10 * kMilli, n * 10 * kMilli);
  log.cloud(15 * kMilli, 101 * kMilli);
  log.cloud(20 * kMilli, 102 * kMilli);
  log.cloud(105 * kMilli, 106 * kMilli);
  log.pose(110 * kMilli, 110 * kMilli);
  const std::vector<double> places = log.places();
  REQUIRE(places.size() == 3);
  CHECK(places[0] == Approx(0.015));
  CHECK(places[1] == Approx(0.020));
  CHECK(places[2] == Approx(0.105));
  CHECK(log.places("") == std::vector<double>{-1.0, -1.0, -1.0});
}

TEST_CASE("a cloud of a log waits for its pose by the clock of the log, and those behind it too",
          "[logs][pose]") {
  PosedLog log;
  log.pose(0, 0);
  log.cloud(10 * kMilli, 10 * kMilli);
  log.cloud(20 * kMilli, 20 * kMilli);
  log.pose(15 * kMilli, 61 * kMilli);   // more than 50 ms after the first cloud
  log.pose(25 * kMilli, 62 * kMilli);   // in time for the second
  log.cloud(40 * kMilli, 70 * kMilli);  // the log ends before its pose
  const std::vector<double> places = log.places();
  REQUIRE(places.size() == 3);
  CHECK(places[0] == -1.0);
  CHECK(places[1] == Approx(0.020));
  CHECK(places[2] == -1.0);
  CHECK(log.places("POSE", 0.1).front() == Approx(0.010));
}

}  // namespace
}  // namespace quadrille

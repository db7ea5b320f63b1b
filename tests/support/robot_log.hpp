#pragma once

#include <cstddef>
#include <cstdint>
#include <lcmtypes/quadrille/robot_t.hpp>
#include <string>
#include <vector>

#include "log/event_log.hpp"
#include "quadrille/bus/encode.hpp"

namespace quadrille::test {

/// Writes a log of clouds with one point on POINT_CLOUD and of messages on a robot on ROBOT, which
/// are told apart by their paddings.
class RobotLog {
 public:
  explicit RobotLog(const std::string& path) : log_(path) {}

  void show(std::int64_t utime) {
    PointCloud cloud;
    cloud.points = {{1.0f, 2.0f, 3.0f}};
    log_.write(utime, "POINT_CLOUD",
               bus::encode_cloud({utime, 0, cloud}, bus::CloudFormat::kDrake));
  }
  /// @param padding  [m]
  void tell(std::int64_t utime, double padding) {
    robot_t robot{};
    robot.utime = utime;
    robot.frame = "camera";
    robot.padding = padding;
    log_.write(utime, "ROBOT", bus::encode(robot));
  }
  /// Tells something that is no message on a robot.
  void tell_nonsense(std::int64_t utime, std::size_t size) {
    log_.write(utime, "ROBOT", std::vector<std::byte>(size));
  }

 private:
  bus::LogWriter log_;
};

}  // namespace quadrille::test

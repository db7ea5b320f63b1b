#pragma once

#include <Eigen/Geometry>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "io/json/json.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille {

/// One cloud of an input, with its name and the time that it took to read.
struct InputCloud {
  io::InputInfo info;
  /// False for the clouds of a scene before the one that is asked for.
  bool asked = true;
  /// The cloud in frame K, which is the camera's if its pose was given, otherwise the cloud's own.
  PointCloud cloud;
  /// Pose of K in the frame C in which results are given: the cloud's own, or the fixed frame W of
  /// the poses on the channel of poses.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity();
  /// For clouds of a log: the channel, and the time of capture [us].
  std::string channel;
  std::int64_t utime = 0;
  /// For clouds of a log: the robot's own shapes in K, and what is fixed to its hand, in the hand's
  /// frame G, as messages tell them.
  RobotShapes robot;
  std::vector<SolidShape> attached;
  /// Share of the input that has been read, from 0 to 1.
  double share = 1.0;
  /// Warnings about the log, with the last cloud that is taken from it.
  std::vector<std::string> warnings;

  /// Sets `info` once the cloud has been read and placed.
  /// @param start  when reading began
  void describe(const std::string& name, std::chrono::steady_clock::time_point start);
};

}  // namespace quadrille

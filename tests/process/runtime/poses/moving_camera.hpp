#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "process/encode_pose.hpp"
#include "process/logged_lines.hpp"
#include "process/runtime/poses/posed_clouds.hpp"

namespace quadrille::test {

inline constexpr std::int64_t kMs = 1000;
/// Speed of the moving camera [m/s].
inline constexpr double kSpeed = 0.5;

/// The clouds of a camera that moves along x, by what comes and when.
class MovingCamera {
 public:
  explicit MovingCamera(double max_wait = 0.05, double max_age = 1.0,
                        std::size_t max_bytes = kMaxBytesWaiting)
      : clouds_({"POSE", {}, max_age, max_wait}, "tracked", max_bytes) {}

  /// A pose of that time comes at that time of the clock.
  void pose(std::int64_t utime, std::int64_t now) {
    pose(utime, now, Eigen::Isometry3d::Identity());
  }
  /// The same with the camera elsewhere than on its way.
  /// @param X_KK  pose of the camera in its frame on the way
  void pose(std::int64_t utime, std::int64_t now, const Eigen::Isometry3d& X_KK) {
    do_all(clouds_.take_due(Node::Time(now)));
    const double x = kSpeed * 1e-6 * static_cast<double>(utime);
    clouds_.receive_pose(encode_pose(utime, Eigen::Translation3d(x, 0, 0) * X_KK), &refusals);
    do_all(clouds_.take_due(Node::Time(now)));
  }
  void cloud(std::int64_t utime, std::int64_t now, std::size_t bytes = 0) {
    do_all(clouds_.take_due(Node::Time(now)));
    if (const auto job = clouds_.add(utime, bytes, note_as(utime))) job->run();
    do_all(clouds_.take_due(Node::Time(now)));
  }
  void pass(std::int64_t now) { do_all(clouds_.take_due(Node::Time(now))); }

  PosedClouds::Then note_as(std::int64_t number) {
    return [this, number](const CameraPose& pose) {
      return Job{number, [this, number, pose] {
                   done.push_back(number);
                   last = pose;
                 }};
    };
  }

  /// Why clouds got no pose, and how many; empty if all did.
  std::string reasons() const {
    std::string text;
    for (const count_t& entry : clouds_.count_poseless()) {
      text += entry.name + " " + std::to_string(entry.count) + " ";
    }
    return text;
  }

  PosedClouds& clouds() { return clouds_; }

  /// In the order in which they were done.
  std::vector<std::int64_t> done;
  CameraPose last;
  Refusals refusals;

 private:
  static void do_all(const std::vector<Job>& jobs) {
    for (const Job& job : jobs) job.run();
  }

  PosedClouds clouds_;
};

}  // namespace quadrille::test

#include "poses/pose_history.hpp"

#include <algorithm>
#include <utility>

namespace quadrille {

Eigen::Isometry3d interpolate(const bus::PoseMessage& before, const bus::PoseMessage& after,
                              std::int64_t utime) {
  const double share =
      seconds_between(before.utime, utime) / seconds_between(before.utime, after.utime);
  const Eigen::Vector3d p0 = before.X_WC.translation(), p1 = after.X_WC.translation();
  const Eigen::Quaterniond R0(before.X_WC.linear()), R1(after.X_WC.linear());
  return Eigen::Translation3d(p0 + share * (p1 - p0)) * R0.slerp(share, R1);
}

Motion motion_between(const bus::PoseMessage& before, const bus::PoseMessage& after) {
  const double seconds = seconds_between(before.utime, after.utime);
  const Eigen::Quaterniond R0(before.X_WC.linear()), R1(after.X_WC.linear());
  return {(after.X_WC.translation() - before.X_WC.translation()).norm() / seconds,
          R0.angularDistance(R1) / seconds};
}

void PoseHistory::add(const bus::PoseMessage& pose) {
  if (!poses_.empty() && seconds_between(pose.utime, poses_.back().utime) > kMaxDisorder) {
    if (!straggler_) {
      straggler_ = pose;
      return;
    }
    poses_.assign(1, *std::exchange(straggler_, std::nullopt));
    return add(pose);
  }
  straggler_.reset();
  const auto place =
      std::lower_bound(poses_.begin(), poses_.end(), pose.utime,
                       [](const auto& known, std::int64_t time) { return known.utime < time; });
  if (place != poses_.end() && place->utime == pose.utime) {
    *place = pose;
  } else {
    poses_.insert(place, pose);
  }
  while (poses_.size() > max_ ||
         seconds_between(poses_.front().utime, poses_.back().utime) > window_) {
    poses_.pop_front();
  }
}

PoseBracket PoseHistory::around(std::int64_t utime) const {
  const auto later =
      std::upper_bound(poses_.begin(), poses_.end(), utime,
                       [](std::int64_t time, const auto& pose) { return time < pose.utime; });
  return {later == poses_.begin() ? nullptr : &*std::prev(later),
          later == poses_.end() ? nullptr : &*later};
}

}  // namespace quadrille

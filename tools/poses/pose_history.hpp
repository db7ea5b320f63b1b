#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "quadrille/bus/pose_message.hpp"

namespace quadrille {

/// Returns the time from one moment to a later one [s]; exact for all times of this era, and
/// without overflow for any.
/// @param from,  to  times [us]
inline double seconds_between(std::int64_t from, std::int64_t to) {
  return 1e-6 * (static_cast<double>(to) - static_cast<double>(from));
}

/// The two poses around a time; null if there is none.
struct PoseBracket {
  /// The last pose at or before the time.
  const bus::PoseMessage* before = nullptr;
  /// The first pose after the time.
  const bus::PoseMessage* after = nullptr;
};

/// Interpolates between two poses, the first not after the given time and the second after it: the
/// origin moves along a straight line, and the rotation turns about one axis (slerp), both at
/// constant speed.
Eigen::Isometry3d interpolate(const bus::PoseMessage& before, const bus::PoseMessage& after,
                              std::int64_t utime);

/// The speed of a camera.
struct Motion {
  double speed = 0.0;  ///< [m/s]
  double turn = 0.0;   ///< [rad/s]
};

/// Returns the motion from one pose to a later one.
Motion motion_between(const bus::PoseMessage& before, const bus::PoseMessage& after);

/// The last poses of a camera in the order of their times, whatever the order of their arrival.
class PoseHistory {
 public:
  /// A pose that is older than the newest by more than this is not merely out of order [s], since
  /// messages do not overtake each other by so much.
  static constexpr double kMaxDisorder = 1.0;

  /// @param window  how far behind the newest pose others are kept [s]
  /// @param most  number of poses to keep, at least 1
  explicit PoseHistory(double window, std::size_t most = 4096) : window_(window), max_(most) {}

  /// Adds a pose, which replaces one of the same time. A pose older than kMaxDisorder is left out.
  /// Two of them in a row mean that the clock was set back, as when a log is replayed; then the
  /// history starts again with these.
  void add(const bus::PoseMessage& pose);

  /// Returns the poses around a time [us]; the pointers are valid until the next pose is added.
  PoseBracket around(std::int64_t utime) const;

  /// Calls visit(pose) for all poses up to a time [us], from the oldest on.
  template <class Visit>
  void each_until(std::int64_t utime, const Visit& visit) const {
    for (const bus::PoseMessage& pose : poses_) {
      if (pose.utime <= utime) visit(pose);
    }
  }

  /// Returns the newest pose; null if there is none.
  const bus::PoseMessage* newest() const { return poses_.empty() ? nullptr : &poses_.back(); }

 private:
  double window_;
  std::size_t max_;
  std::deque<bus::PoseMessage> poses_;
  /// The last pose that came, if it was too old.
  std::optional<bus::PoseMessage> straggler_;
};

}  // namespace quadrille

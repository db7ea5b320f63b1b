#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "quadrille/bus/pose_message.hpp"

namespace quadrille {

/// From one time to a later one [s]; exact for all times of this age, and without overflow for all.
/// @param from, to  [us]
inline double seconds_between(std::int64_t from, std::int64_t to) {
  return 1e-6 * (static_cast<double>(to) - static_cast<double>(from));
}

/// The poses about a time; null where there is none.
struct PoseBracket {
  /// The last at or before it.
  const bus::PoseMessage* before = nullptr;
  /// The first after it.
  const bus::PoseMessage* after = nullptr;
};

/// The pose at a time between those of two poses, the first not after it and the second after it:
/// the origin moves along the straight line, the rotation about one axis (slerp), both evenly.
Eigen::Isometry3d interpolate(const bus::PoseMessage& before, const bus::PoseMessage& after,
                              std::int64_t utime);

/// How a camera moves.
struct Motion {
  double speed = 0.0;  ///< [m/s]
  double turn = 0.0;   ///< [rad/s]
};

/// The motion from one pose to a later one.
Motion motion_between(const bus::PoseMessage& before, const bus::PoseMessage& after);

/// The last poses of a camera in the order of their times, in whatever order they come.
class PoseHistory {
 public:
  /// A pose that is older than the newest by more than this is not merely out of order [s]:
  /// messages do not overtake each other by so much.
  static constexpr double kMaxDisorder = 1.0;

  /// @param window  how far behind the newest poses are kept [s]
  /// @param most    poses to keep, at least 1
  explicit PoseHistory(double window, std::size_t most = 4096) : window_(window), max_(most) {}

  /// Adds a pose; it replaces one of the same time. Older ones than kMaxDisorder have no part in
  /// the history, but two of them in a row mean that the clock was set back, as when a log is
  /// played anew: then the history begins with these.
  void add(const bus::PoseMessage& pose);

  /// The poses about that time [us]; they live until the next one is added.
  PoseBracket around(std::int64_t utime) const;

  /// The newest pose; null if there is none.
  const bus::PoseMessage* newest() const { return poses_.empty() ? nullptr : &poses_.back(); }

 private:
  double window_;
  std::size_t max_;
  std::deque<bus::PoseMessage> poses_;
  /// The last pose that came, if it was too old.
  std::optional<bus::PoseMessage> straggler_;
};

}  // namespace quadrille

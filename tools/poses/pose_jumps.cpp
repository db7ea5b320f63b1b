#include "poses/pose_jumps.hpp"

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

namespace quadrille {
namespace {

// No camera moves or turns faster while it looks: arms move their hands at up to 2 m/s, and a
// person turns a camera at some 5 rad/s [m/s], [rad/s].
constexpr double kMaxSpeed = 3.0, kMaxTurn = 10.0;
// Poses that are nearer to each other differ by their noise, however soon they follow [m], [rad].
constexpr double kNoJump = 0.05, kNoTurn = 0.2;
// A frame that was set anew is believed after this time [s].
constexpr double kUntilBelieved = 1.0;
// If a larger share of the steps from pose to pose jumps, the camera is put from place to place.
constexpr double kMaxShare = 0.2;

/// True if no camera moves from one pose to a later one in the time between them.
bool is_jump(const bus::PoseMessage& before, const bus::PoseMessage& after) {
  const double seconds = seconds_between(before.utime, after.utime);
  const Motion motion = motion_between(before, after);
  return (motion.speed > kMaxSpeed && motion.speed * seconds > kNoJump) ||
         (motion.turn > kMaxTurn && motion.turn * seconds > kNoTurn);
}

/// Adds up the jumps of a camera's poses, which cancel out if the poses come back.
class Jumps {
 public:
  /// Adds the step from a pose to the next one.
  void add(const bus::PoseMessage& before, const bus::PoseMessage& after) {
    ++steps_;
    if (is_believed(after.utime)) settle();
    if (!is_jump(before, after)) return;
    ++jumps_;
    last_ = after.utime;
    shift_ += after.X_WC.translation() - before.X_WC.translation();
    turn_ = Eigen::Quaterniond(after.X_WC.linear() * before.X_WC.linear().transpose()) * turn_;
    if (shift_.norm() <= kNoJump && turn_.angularDistance(kNone) <= kNoTurn) settle();
  }

  bool are_rare() const { return jumps_ < kMaxShare * steps_; }
  /// True if the poses came back from all jumps, or are believed since.
  bool are_settled() const { return !last_; }

 private:
  inline static const Eigen::Quaterniond kNone = Eigen::Quaterniond::Identity();

  bool is_believed(std::int64_t utime) const {
    return last_ && seconds_between(*last_, utime) >= kUntilBelieved;
  }
  void settle() {
    last_.reset();
    shift_.setZero();
    turn_ = kNone;
  }

  int steps_ = 0, jumps_ = 0;
  /// The time of the last jump [us]; nullopt if they are settled.
  std::optional<std::int64_t> last_;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn_ = kNone;
};

}  // namespace

bool have_jumped(const PoseHistory& history, const PoseBracket& bracket) {
  const bus::PoseMessage& last = bracket.after ? *bracket.after : *bracket.before;
  Jumps jumps;
  const bus::PoseMessage* previous = nullptr;
  history.each_until(last.utime, [&](const bus::PoseMessage& pose) {
    if (previous) jumps.add(*previous, pose);
    previous = &pose;
  });
  if (!jumps.are_rare()) return false;
  return !jumps.are_settled() || (bracket.after && is_jump(*bracket.before, *bracket.after));
}

}  // namespace quadrille

#include "poses/camera_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quadrille {
namespace {

// A cloud may arrive this long after it was taken and still finds its poses [s].
constexpr double kCloudDelay = 1.0;
// In this time, an arm at a usual speed of half a metre per second moves one centimetre [s].
constexpr double kFarInTime = 0.02;
// Depth noise at the distance at which hands work; smaller misplacements do not show [m].
constexpr double kFarInSpace = 1e-3;
// Distance of objects for which the effect of the camera's rotation is estimated [m].
constexpr double kReach = 1.0;

// No camera moves or turns faster: hands of arms reach 4 m/s, and their wrists turn at some 5 rad/s
// about each of three axes, whose rates at most add up [m/s], [rad/s].
constexpr double kMaxSpeed = 5.0, kMaxTurn = 15.0;
// Poses that are nearer to each other differ by their noise, however soon they follow [m], [rad].
constexpr double kNoJump = 0.05, kNoTurn = 0.2;

constexpr double kMsPerSecond = 1e3, kMmPerMetre = 1e3;

constexpr const char* kRemedy =
    "publish poses faster; for a camera at rest give --camera-pose instead";

/// Returns "at 0.50 m/s that is up to 100 mm"; empty if it is less than the noise.
std::string describe_misplacement(double age, const Motion& motion) {
  const double by_turn = age * motion.turn * kReach;
  const double misplacement = age * motion.speed + by_turn;
  if (misplacement < kFarInSpace) return "";
  const std::string turn =
      by_turn < kFarInSpace
          ? ""
          : fmt::format(" and {:.0f} °/s", motion.turn * 180.0 / std::numbers::pi);
  return fmt::format("at {:.2f} m/s{} that is up to {:.0f} mm{}", motion.speed, turn,
                     misplacement * kMmPerMetre, turn.empty() ? "" : " a metre away");
}

/// True if no camera moves from one pose to a later one in the time between them.
bool is_far(const bus::PoseMessage& before, const bus::PoseMessage& after) {
  const double seconds = seconds_between(before.utime, after.utime);
  const Motion motion = motion_between(before, after);
  return (motion.speed > kMaxSpeed && motion.speed * seconds > kNoJump) ||
         (motion.turn > kMaxTurn && motion.turn * seconds > kNoTurn);
}

}  // namespace

CameraPoses::CameraPoses(double max_age, double max_wait)
    : max_age_(max_age), max_wait_(max_wait), history_(2.0 * max_age + kCloudDelay) {}

CameraPose CameraPoses::at(std::int64_t utime) const {
  CameraPose pose;
  const PoseBracket bracket = history_.around(utime);
  const double far = std::numeric_limits<double>::infinity();
  const double since = bracket.before ? seconds_between(bracket.before->utime, utime) : far;
  const double until = bracket.after ? seconds_between(utime, bracket.after->utime) : far;
  // If no double distinguishes two (hostile) times, there is nothing to interpolate.
  if (since == 0.0) {
    pose.age = 0.0;
    if (jumps_to(*bracket.before)) {
      pose.lack = PoseLack::kJump;
    } else {
      pose.X_WK = bracket.before->X_WC;
    }
  } else if (since <= max_age_ && until <= max_age_) {
    pose.age = std::min(since, until);
    pose.motion = motion_between(*bracket.before, *bracket.after);
    if (jumps(*bracket.before, *bracket.after)) {
      pose.lack = PoseLack::kJump;
    } else {
      pose.X_WK = interpolate(*bracket.before, *bracket.after, utime);
    }
  } else if (history_.newest()) {
    pose.age = std::abs(seconds_between(history_.newest()->utime, utime));
    pose.motion = newest_motion();
    if (bracket.before) {
      pose.lack = since <= max_age_ && !bracket.after ? PoseLack::kLatePose : PoseLack::kOldPose;
    }
  }
  return pose;
}

/// True if no camera moves from one pose to a later one, although it moved from most poses to the
/// next until then. Otherwise the log shows a camera that is put from place to place.
bool CameraPoses::jumps(const bus::PoseMessage& before, const bus::PoseMessage& after) const {
  if (!is_far(before, after)) return false;
  int balance = 0;
  const bus::PoseMessage* previous = nullptr;
  history_.each_until(before.utime, [&](const bus::PoseMessage& pose) {
    if (previous != nullptr) balance += is_far(*previous, pose) ? -1 : 1;
    previous = &pose;
  });
  return balance > 0;
}

/// True if no camera moves to a pose from the one before it.
bool CameraPoses::jumps_to(const bus::PoseMessage& pose) const {
  if (pose.utime == std::numeric_limits<std::int64_t>::min()) return false;
  const bus::PoseMessage* before = history_.around(pose.utime - 1).before;
  return before != nullptr && seconds_between(before->utime, pose.utime) <= max_age_ &&
         jumps(*before, pose);
}

bool CameraPoses::jumped_between(const bus::PoseMessage& before,
                                 const bus::PoseMessage& after) const {
  bus::PoseMessage previous = before;
  std::optional<bus::PoseMessage> left, reached;
  const auto step_to = [&](const bus::PoseMessage& pose) {
    if (pose.utime <= before.utime) return;
    if (is_far(previous, pose)) {
      if (!left) left = previous;
      reached = pose;
    }
    previous = pose;
  };
  history_.each_until(after.utime, step_to);
  step_to(after);
  return left && jumps(*left, *reached);
}

/// Estimates the motion from the newest pose and the last one before it that is far enough in time
/// that noise does not look like motion.
Motion CameraPoses::newest_motion() const {
  const bus::PoseMessage& newest = *history_.newest();
  const auto earlier = static_cast<std::int64_t>(kFarInTime * 1e6);
  if (newest.utime < std::numeric_limits<std::int64_t>::min() + earlier) return {};
  const bus::PoseMessage* before = history_.around(newest.utime - earlier).before;
  return before ? motion_between(*before, newest) : Motion{};
}

std::string CameraPoses::explain(std::int64_t utime, const CameraPose& none) const {
  const PoseBracket bracket = history_.around(utime);
  if (!history_.newest()) {
    return "no pose has come; is --pose-channel right, and does anyone send on it?";
  }
  if (none.lack == PoseLack::kJump) {
    return "the poses about it are farther apart than a camera moves in that time; one of them is "
           "wrong, or the fixed frame was set anew: then drop what older clouds showed (FORGET)";
  }
  if (!bracket.before) return "all poses kept are newer; do both senders use one clock?";
  const double since = seconds_between(bracket.before->utime, utime);
  if (since > max_age_) {
    return fmt::format(
        "the last pose before it is {:.3g} s older, more than track.pose_age = {:g} s; "
        "does anyone still send poses?",
        since, max_age_);
  }
  if (none.lack == PoseLack::kOldPose) {
    return fmt::format(
        "the first pose after it is {:.3g} s newer, more than track.pose_age = {:g} s; {}",
        seconds_between(utime, bracket.after->utime), max_age_, kRemedy);
  }
  const std::string misplacement = describe_misplacement(since, none.motion);
  return fmt::format(
      "the newest pose is {:.0f} ms older{}{}, and none after the cloud came within "
      "track.pose_wait = {:g} s; raise that, or {}",
      since * kMsPerSecond, misplacement.empty() ? "" : "; ", misplacement, max_wait_, kRemedy);
}

std::string describe_if_far(const CameraPose& pose) {
  if (!pose.X_WK || !pose.age || *pose.age <= kFarInTime) return "";
  const std::string misplacement = describe_misplacement(*pose.age, pose.motion);
  if (misplacement.empty()) return "";
  return fmt::format("poses are {:.0f} ms from the clouds; {}; {}", *pose.age * kMsPerSecond,
                     misplacement, kRemedy);
}

}  // namespace quadrille

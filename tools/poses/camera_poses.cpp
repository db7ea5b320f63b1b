#include "poses/camera_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "poses/pose_jumps.hpp"

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

void refuse_jump(CameraPose* pose) {
  pose->X_WK.reset();
  pose->lack = PoseLack::kJump;
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
    pose.X_WK = bracket.before->X_WC;
    pose.age = 0.0;
    if (have_jumped(history_, {bracket.before, nullptr})) refuse_jump(&pose);
  } else if (since <= max_age_ && until <= max_age_) {
    pose.X_WK = interpolate(*bracket.before, *bracket.after, utime);
    pose.age = std::min(since, until);
    pose.motion = motion_between(*bracket.before, *bracket.after);
    if (have_jumped(history_, bracket)) refuse_jump(&pose);
  } else if (history_.newest()) {
    pose.age = std::abs(seconds_between(history_.newest()->utime, utime));
    pose.motion = newest_motion();
    if (bracket.before) {
      pose.lack = since <= max_age_ && !bracket.after ? PoseLack::kLatePose : PoseLack::kOldPose;
    }
  }
  return pose;
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
    return "the poses jumped about it, or in the second before; one of them is wrong, or the fixed "
           "frame was set anew: then drop what older clouds showed (FORGET)";
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

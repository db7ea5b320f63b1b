#include "view/live/camera_trail.hpp"

#include <cmath>
#include <variant>

#include "poses/pose_history.hpp"
#include "quadrille/detector/tracker.hpp"

namespace quadrille::view {
namespace {

/// The view has no settings of its own, so poses may be as old as the processes allow by default.
double pose_age() { return TrackOptions{}.pose_age; }

}  // namespace

CameraTrail::CameraTrail() : poses_(pose_age(), TrackOptions{}.pose_wait) {}

void CameraTrail::add(std::span<const std::byte> bytes) {
  const auto decoded = bus::decode_pose(bytes);
  const auto* const pose = std::get_if<bus::PoseMessage>(&decoded);
  if (pose == nullptr) return;
  poses_.add(*pose);
  // If the clock was set back, as when a log is played again, the camera did not come from here.
  const bool set_back =
      last_ && seconds_between(pose->utime, last_->utime) > PoseHistory::kMaxDisorder;
  if (set_back) path_.clear();
  last_ = *pose;
  const Eigen::Vector3d p_W = pose->X_WC.translation();
  if (!path_.empty() && (p_W - path_.back()).norm() < kStep) return;
  path_.push_back(p_W);
  if (path_.size() > kMaxPath) path_.pop_front();
}

std::optional<Eigen::Isometry3d> CameraTrail::at(std::int64_t utime) const {
  if (const CameraPose pose = poses_.at(utime); pose.X_WK) return pose.X_WK;
  // A page is to show a cloud at once and does not wait for the pose after it. The newest pose is a
  // little wrong if the camera moves, but better than no cloud; the processes do not use it so.
  if (!last_ || std::abs(seconds_between(utime, last_->utime)) > pose_age()) return std::nullopt;
  return last_->X_WC;
}

std::string CameraTrail::explain(std::int64_t utime) const {
  return poses_.explain(utime, poses_.at(utime));
}

}  // namespace quadrille::view

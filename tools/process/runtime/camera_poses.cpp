#include "process/runtime/camera_poses.hpp"

#include <fmt/format.h>

namespace quadrille {

CameraPose CameraPoses::at(std::int64_t utime) const {
  if (fixed_) return {fixed_, {}, {}};
  const std::optional<bus::PoseMessage> pose = history_.at(utime);
  if (!pose) {
    return {std::nullopt, PoseLack::kNoPose,
            history_.empty()
                ? "no pose has come; is --pose-channel right, and does anyone send on it?"
                : "all poses kept are newer; do both senders use one clock?"};
  }
  // Times of hostile messages may lie further apart than integers reach.
  const double age = 1e-6 * (static_cast<double>(utime) - static_cast<double>(pose->utime));
  if (age <= max_age_) return {pose->X_WC, {}, {}};
  return {std::nullopt, PoseLack::kOldPose,
          fmt::format("the newest pose is {:.1f} s older, more than track.pose_age = {:g} s", age,
                      max_age_)};
}

Placement place(const CloudFrames& frames, const CameraPose& pose) {
  Placement placement;
  placement.X_WK = pose.X_WK;
  if (!frames.need_pose()) return placement;
  if (frames.of_results() != frames.clouds) placement.frame = word_of(frames.of_results());
  if (!pose.X_WK) {
    placement.lack = pose.detail;
    return placement;
  }
  if (frames.clouds == CloudFrame::kWorld) placement.X_CK = *pose.X_WK;
  if (frames.of_results() == CloudFrame::kWorld) placement.X_RK = *pose.X_WK;
  return placement;
}

}  // namespace quadrille

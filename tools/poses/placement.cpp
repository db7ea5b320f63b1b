#include "poses/placement.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "poses/cloud_frame.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {

Eigen::Isometry3d pose_of_camera(const std::string& frame, const Placement& placement,
                                 const std::string& cloud_frame) {
  if (!placement.lack.empty()) {
    throw std::invalid_argument("the camera's pose is not known: " + placement.lack);
  }
  if (frame.empty() || frame == placement.frame_of_results(cloud_frame)) return placement.X_RK;
  if (frame == to_string(CloudFrame::kCamera)) return Eigen::Isometry3d::Identity();
  if (frame == cloud_frame) return placement.X_CK;
  if (frame != to_string(CloudFrame::kWorld)) {
    throw std::invalid_argument(
        fmt::format("frame '{}' is not known: name 'camera', 'world', the cloud's ('{}') or ''",
                    printable(frame), printable(cloud_frame)));
  }
  if (!placement.X_WK) {
    throw std::invalid_argument(
        "frame 'world' is not known: no pose has come, or --pose-channel and --camera-pose are not "
        "given");
  }
  return *placement.X_WK;
}

}  // namespace quadrille

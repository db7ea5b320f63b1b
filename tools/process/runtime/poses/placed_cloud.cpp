#include "process/runtime/poses/placed_cloud.hpp"

#include "quadrille/detector/detection.hpp"

namespace quadrille {

bus::Decoded<bus::CloudMessage> decode_cloud(std::span<const std::byte> bytes,
                                             const CloudFrames& frames) {
  return bus::decode_cloud(bytes, bus::kMaxMessageBytes, bus::CloudColours::kDrop, frames.unit);
}

Placement place(const CloudFrames& frames, const CameraPose& pose) {
  Placement placement;
  placement.X_WK = pose.X_WK;
  if (!frames.need_pose()) return placement;
  if (frames.of_results() != frames.clouds) placement.frame = to_string(frames.of_results());
  if (!pose.X_WK) {
    placement.lack = pose.detail;
    return placement;
  }
  if (frames.clouds == CloudFrame::kWorld) placement.X_CK = *pose.X_WK;
  if (frames.of_results() == CloudFrame::kWorld) placement.X_RK = *pose.X_WK;
  return placement;
}

PointCloud in_camera_frame(const PointCloud& cloud, const Placement& placement,
                           const CloudFrames& frames) {
  PointCloud cloud_K = moved(cloud, placement.X_CK.inverse());
  if (frames.clouds == CloudFrame::kWorld) cloud_K.viewpoint.setZero();
  return cloud_K;
}

}  // namespace quadrille

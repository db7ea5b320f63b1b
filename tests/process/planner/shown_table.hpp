#pragma once

// A table with a can and a ball, shown to both processes from places round it.

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "process/chain.hpp"
#include "process/encode_pose.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

inline constexpr std::int64_t kUsPerSecond = 1'000'000;
inline const Eigen::Vector3d kFront(0.1, -0.55, 0.4), kBack(-0.2, 0.5, 0.45);

/// A can and a ball on a table, of which W is the frame, and a robot's finger if it is wanted.
inline std::vector<Patch> patches_on_table(bool with_finger = false) {
  std::vector<Patch> patches = can(translation(0, 0, 0.05), 0.03, 0.1);
  patches.push_back(sphere(translation(0.15, 0.05, 0.03), 0.03));
  patches.push_back(rectangle(Eigen::Isometry3d::Identity(), 1.2, 1.0));
  if (with_finger) {
    for (const Patch& face : box(translation(0.06, -0.07, 0.12), {0.02, 0.02, 0.16})) {
      patches.push_back(face);
    }
  }
  return patches;
}

/// Gives a cloud of a camera at this place, with its pose, on the channels of that camera.
inline void take_from(Chain& chain, const std::string& clouds, const std::string& poses,
                      std::int64_t utime, const Eigen::Vector3d& eye_W, bool with_finger = false) {
  const Eigen::Isometry3d X_KW = world_seen_from(eye_W);
  std::vector<Patch> patches = patches_on_table(with_finger);
  for (Patch& patch : patches) patch.X_CB = X_KW * patch.X_CB;
  Camera camera;
  camera.noise = 0.0005;
  PointCloud cloud = render(patches, camera);
  cloud.frame = "eye";
  chain.take(poses, encode_pose(utime, X_KW.inverse()));
  chain.take(clouds, bus::encode_cloud({utime, 0, cloud}, bus::CloudFormat::kDrake));
}

/// Gives a cloud of the first camera, on which grasps are planned.
inline void show_from(Chain& chain, std::int64_t utime, const Eigen::Vector3d& eye_W,
                      bool with_finger = false) {
  take_from(chain, "POINT_CLOUD", "POSE", utime, eye_W, with_finger);
  REQUIRE(chain.grasps().utime == utime);
}

inline int refused_as(const grasps_t& grasps, const std::string& why) {
  for (const count_t& entry : grasps.rejected) {
    if (entry.name == why) return static_cast<int>(entry.count);
  }
  return 0;
}

inline const std::string kCautious = "--pose-channel POSE --unknown obstacle";

}  // namespace quadrille::test

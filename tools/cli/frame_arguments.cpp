#include "cli/frame_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <vector>

#include "cli/number_list.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

// A quaternion may miss unit norm by rounding to a few digits.
constexpr double kUnitNorm = 1e-2;

Eigen::Vector3d viewpoint_of(const std::string& list) {
  const std::vector<double> v = numbers_of("--viewpoint", list, 3, "X,Y,Z");
  return {v[0], v[1], v[2]};
}

Eigen::Isometry3d pose_of(const std::string& list) {
  const std::vector<double> v = numbers_of("--camera-pose", list, 7, "X,Y,Z,QW,QX,QY,QZ");
  const Eigen::Quaterniond q(v[3], v[4], v[5], v[6]);
  if (!(std::abs(q.norm() - 1.0) < kUnitNorm)) {
    throw CLI::ValidationError(
        "--camera-pose",
        fmt::format("the quaternion of '{}' has norm {:.3g}; give a unit one, QW first",
                    printable(list), q.norm()));
  }
  return Eigen::Translation3d(v[0], v[1], v[2]) * q.normalized();
}

}  // namespace

void CameraPoseArgument::add_to(CLI::App& app, const std::string& rival) {
  app.add_option_function<std::string>(
         "--camera-pose", [this](const std::string& text) { X_WK = pose_of(text); },
         "Pose of the camera (z ahead, x along its rows) in the frame of the cloud or robot")
      ->type_name("X,Y,Z,QW,QX,QY,QZ")
      ->excludes(app.get_option(rival));
}

void FrameArguments::add_to(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--viewpoint", [this](const std::string& text) { viewpoint = viewpoint_of(text); },
          "Where the sensor stood, in the cloud's frame [m], over what the file says")
      ->type_name("X,Y,Z");
  camera.add_to(command, "--viewpoint");
}

Eigen::Isometry3d FrameArguments::working_frame() const {
  return camera.X_WK.value_or(Eigen::Isometry3d::Identity());
}

void FrameArguments::place_viewpoint(PointCloud* cloud) const {
  if (camera.X_WK) cloud->viewpoint.setZero();
  if (viewpoint) cloud->viewpoint = *viewpoint;
}

}  // namespace quadrille

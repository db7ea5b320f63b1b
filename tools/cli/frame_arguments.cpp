#include "cli/frame_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <vector>

#include "cli/number_list.hpp"
#include "cli/unit_option.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

// A quaternion may miss unit norm by rounding to a few digits.
constexpr double kUnitNorm = 1e-2;

constexpr const char* kCameraPose =
    "Pose of the camera (z ahead, x along its rows) in the frame of the cloud or robot";
constexpr const char* kPoseType = "X,Y,Z,QW,QX,QY,QZ";

Eigen::Vector3d viewpoint_of(const std::string& list) {
  const std::vector<double> v = numbers_of("--viewpoint", list, 3, "X,Y,Z");
  return {v[0], v[1], v[2]};
}

void add_viewpoint_option(CLI::App& command, std::optional<Eigen::Vector3d>& viewpoint) {
  command
      .add_option_function<std::string>(
          "--viewpoint", [&viewpoint](const std::string& text) { viewpoint = viewpoint_of(text); },
          "Where the sensor stood, in the cloud's frame [m], over what the file says")
      ->type_name("X,Y,Z");
}

}  // namespace

Eigen::Isometry3d camera_pose_of(const std::string& option, const std::string& list) {
  const std::vector<double> v = numbers_of(option, list, 7, kPoseType);
  const Eigen::Quaterniond q(v[3], v[4], v[5], v[6]);
  if (!(std::abs(q.norm() - 1.0) < kUnitNorm)) {
    throw CLI::ValidationError(
        option, fmt::format("the quaternion of '{}' has norm {:.3g}; give a unit one, QW first",
                            printable(list), q.norm()));
  }
  return Eigen::Translation3d(v[0], v[1], v[2]) * q.normalized();
}

void CameraPoseArgument::add_to(CLI::App& app, const std::string& rival) {
  app.add_option_function<std::string>(
         "--camera-pose",
         [this](const std::string& text) { X_WK = camera_pose_of("--camera-pose", text); },
         kCameraPose)
      ->type_name(kPoseType)
      ->excludes(app.get_option(rival));
}

void FrameArguments::add_to(CLI::App& command) {
  add_viewpoint_option(command, viewpoint);
  camera.add_to(command, "--viewpoint");
  add_unit_option(command, unit);
}

void FrameArguments::add_for_inputs_to(CLI::App& command) {
  add_viewpoint_option(command, viewpoint);
  command
      .add_option_function<std::vector<std::string>>(
          "--camera-pose",
          [this](const std::vector<std::string>& texts) {
            for (const std::string& text : texts)
              cameras.push_back(camera_pose_of("--camera-pose", text));
            camera.X_WK = cameras.front();
          },
          std::string(kCameraPose) + "; once, or once for each INPUT")
      ->type_name(kPoseType)
      ->allow_extra_args(false)
      ->excludes("--viewpoint");
  add_unit_option(command, unit);
}

void FrameArguments::check(std::size_t inputs) const {
  if (cameras.size() < 2 || cameras.size() == inputs) return;
  throw CLI::ValidationError(
      "--camera-pose",
      fmt::format("is given {} times for {} INPUTs; give it once, or once for each", cameras.size(),
                  inputs));
}

FrameArguments FrameArguments::of_input(std::size_t n) const {
  FrameArguments one = *this;
  if (cameras.size() > 1) one.camera.X_WK = cameras[n];
  one.cameras.clear();
  return one;
}

Eigen::Isometry3d FrameArguments::working_frame() const {
  return camera.X_WK.value_or(Eigen::Isometry3d::Identity());
}

Eigen::Affine3d FrameArguments::from_file() const {
  return working_frame().inverse() * Eigen::Scaling(unit);
}

Placement FrameArguments::placement() const {
  Placement placement;
  placement.X_CK = placement.X_RK = working_frame();
  placement.X_WK = camera.X_WK;
  return placement;
}

void FrameArguments::place_viewpoint(PointCloud* cloud) const {
  if (camera.X_WK) cloud->viewpoint.setZero();
  if (viewpoint) cloud->viewpoint = *viewpoint;
}

}  // namespace quadrille

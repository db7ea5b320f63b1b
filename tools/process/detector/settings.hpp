#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "cli/process_arguments.hpp"
#include "process/runtime/poses/cloud_frames.hpp"
#include "process/runtime/poses/view_camera.hpp"
#include "process/runtime/viewer.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/tracker.hpp"

namespace quadrille {

/// The settings of the process, from its command line.
struct DetectorSettings {
  ProcessArguments process;
  /// Channel of the clouds, or a pattern as bus::ChannelPattern accepts it. With a pattern, the
  /// results of each channel go to separate channels, whose names end in its name.
  std::string in_channel = "POINT_CLOUD";
  std::string out_channel = "QUADRICS";
  std::string boxes_channel = "BOXES";
  std::string bodies_channel = "BODIES";
  std::string body_tracks_channel = "BODY_TRACKS";
  std::string status_channel = "QUADRILLE_DETECTOR_STATUS";
  std::string robot_channel = "ROBOT";
  std::string forget_channel = "FORGET";
  /// Channel of the camera's poses; empty for a camera at rest.
  std::string pose_channel;
  /// Pose of a camera at rest in W; nullopt if it is not known.
  std::optional<Eigen::Isometry3d> X_WK;
  CloudFrames frames;
  /// Further cameras that look at the scene.
  std::vector<ViewCamera> view_cameras;
  /// Whether messages for the viewer are published, and the channels, which Meldis knows.
  bool viz = false;
  ViewerChannels viewer = {"DRAKE_VIEWER_LOAD_ROBOT", "DRAKE_VIEWER_DRAW"};
  std::string viewer_cloud_channel = "DRAKE_POINT_CLOUD";
  DetectorOptions detector;
  TrackOptions track;
  /// The robot's own shapes, in the fixed frame of the camera's poses, or, if there are none, in
  /// the camera's frame.
  RobotShapes robot;

  /// Returns true if the camera's pose in W is given, or comes on a channel.
  bool has_fixed_frame() const { return X_WK || !pose_channel.empty(); }

  /// Returns true if what other clouds showed serves later ones. A camera at rest shows the same
  /// again.
  bool remembers() const {
    const bool others = !pose_channel.empty() || !view_cameras.empty();
    return others && detector.views.remember > 0.0;
  }

  /// Lists each channel: the direction of its messages, the option that names it, its name, and its
  /// content.
  template <class Settings, class Visit>
  static void visit_channels(Settings& settings, const Visit& visit) {
    visit(Way::kIn, "--in-channel", settings.in_channel, "clouds");
    visit(Way::kOut, "--out-channel", settings.out_channel, "quadrics");
    visit(Way::kOut, "--boxes-channel", settings.boxes_channel, "boxes");
    visit(Way::kOut, "--bodies-channel", settings.bodies_channel, "bodies");
    visit(Way::kOut, "--body-tracks-channel", settings.body_tracks_channel, "tracks of bodies");
    visit(Way::kOut, "--status-channel", settings.status_channel, "status");
    visit(Way::kIn, "--robot-channel", settings.robot_channel,
          "the robot's own shapes (quadrille.robot_t)");
    visit(Way::kIn, "--forget-channel", settings.forget_channel,
          "what to forget of earlier clouds (quadrille.forget_t)");
    visit(Way::kIn, "--pose-channel", settings.pose_channel,
          "camera's poses (bot_core.pose_t) in a fixed frame");
    visit_view_cameras(settings.view_cameras, visit);
  }

  /// Lists the channels of the viewer, if there is one.
  template <class Settings, class Visit>
  static void visit_viewer(Settings& settings, const Visit& visit) {
    if (!settings.viz) return;
    visit(settings.viewer.load);
    visit(settings.viewer.draw);
    visit(settings.viewer_cloud_channel);
  }
};

}  // namespace quadrille

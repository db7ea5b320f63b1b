#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "poses/robot_trail.hpp"
#include "view/live/camera_trail.hpp"

namespace quadrille::view {

/// The channels of the messages that are shown, and of requests to the planner, and the frame and
/// the unit of the clouds.
struct LiveChannels {
  std::string cloud = "POINT_CLOUD", quadrics = "QUADRICS", boxes = "BOXES", bodies = "BODIES",
              body_tracks = "BODY_TRACKS", grasps = "GRASPS", occupancy = "OCCUPANCY",
              robot = "ROBOT", obstacles = "OBSTACLES",
              detector_status = "QUADRILLE_DETECTOR_STATUS",
              planner_status = "QUADRILLE_PLANNER_STATUS", requests = "GRASP_REQUEST";
  /// The channel of the camera's poses; empty if there are none.
  std::string poses;
  /// True if clouds are in the fixed frame of these poses; else they are in the camera's frame.
  bool cloud_in_world = false;
  /// Length of the unit of the clouds' coordinates [m].
  double unit = 1.0;

  /// Calls v(name) for each channel on which messages come.
  template <class Channels, class Visitor>
  static void visit_inputs(Channels& c, Visitor&& v) {
    for (auto* const name :
         {&c.cloud, &c.quadrics, &c.boxes, &c.bodies, &c.body_tracks, &c.grasps, &c.occupancy,
          &c.robot, &c.obstacles, &c.poses, &c.detector_status, &c.planner_status}) {
      v(*name);
    }
  }
};

/// The bytes of a message, which several owners may share; null for none.
using Bytes = std::shared_ptr<const std::vector<std::byte>>;

/// The newest message of each kind, and the last few clouds, poses and shapes of the robot, because
/// quadrics come later than these.
struct LatestMessages {
  std::deque<Bytes> clouds;
  /// The boxes, bodies and tracks of bodies before the newest, used until the quadrics of the
  /// newest have come.
  Bytes boxes_before, bodies_before, body_tracks_before;
  Bytes quadrics, boxes, bodies, body_tracks, grasps, occupancy, obstacles, detector_status,
      planner_status;
  RobotTrail robot;
  /// The camera's poses; nullopt if no channel of them is given.
  std::optional<CameraTrail> camera;
};

/// Keeps messages from the bus until a browser looks at them. Taking a message never waits for
/// browsers, and clouds are kept only while one is looking.
class MessageKeeper {
 public:
  /// Limits of the number of clouds that are kept, and of their bytes, not counting the newest.
  static constexpr std::size_t kMaxClouds = 8, kMaxCloudBytes = std::size_t{64} << 20;

  explicit MessageKeeper(LiveChannels channels);

  /// Takes one message. Messages of other channels are ignored, and so are answers to other
  /// programs' requests while the planner plans for all objects by itself.
  void take(const std::string& channel, std::span<const std::byte> bytes);

  /// Notes that a browser is looking, for the next few seconds at least.
  void watch();
  /// Waits for a message from which a new scene can be made; false if none came, or no browser is
  /// looking.
  bool wait(std::chrono::milliseconds timeout);
  /// Returns the newest messages; their bytes are shared, not copied.
  LatestMessages latest() const;

  const LiveChannels& channels() const { return channels_; }

 private:
  using Clock = std::chrono::steady_clock;

  void keep_cloud(Bytes bytes);

  LiveChannels channels_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  LatestMessages latest_;
  std::size_t cloud_bytes_ = 0;
  bool has_news_ = false;
  Clock::time_point watched_until_{}, quadrics_came_{}, plan_came_{};
};

}  // namespace quadrille::view

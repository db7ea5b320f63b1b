#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/setting.hpp"

namespace quadrille {

/// Options for recognising surfaces from cloud to cloud.
struct TrackOptions {
  bool enabled = true;
  double gate = 4.0;
  double forget_after = 1.0;
  double speed = 0.5;
  double acceleration = 1.0;
  double pose_age = 1.0;
  double pose_wait = 0.05;

  /// Calls v(field, Setting) for each option, in the order of the configuration file.
  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.enabled, {"track.enabled", "Whether surfaces and bodies get tracks."});
    v(o.gate, {"track.gate", "", 1e-6, 100.0,
               "Largest difference between a track and its next detection, in standard deviations "
               "of place, shape and dimensions together."});
    v(o.forget_after, {"track.forget_after", "s", 0.0, 1e6,
                       "How long a track is remembered while nothing is seen of it; three frames "
                       "in any case."});
    v(o.speed,
      {"track.speed", "m/s", 0.0, 1000.0, "Standard deviation of the speed of what is new."});
    v(o.acceleration, {"track.acceleration", "m/s²", 0.0, 1000.0,
                       "Standard deviation of the acceleration, of hands that move things and so "
                       "on."});
    v(o.pose_age, {"track.pose_age", "s", 0.0, 1e6,
                   "Longest time between a cloud and the camera's pose before it, and likewise the "
                   "one after it, where poses come as messages of their own; what lies further off "
                   "counts as none. The Tracker itself takes whatever pose it is given."});
    v(o.pose_wait, {"track.pose_wait", "s", 0.0, 10.0,
                    "How long a cloud waits for the camera's pose after it, where poses come as "
                    "messages of their own; one that waits in vain has no pose. No cloud does if "
                    "this is more than the time between two poses and their delay together."});
  }

  /// @throws std::invalid_argument naming the field that is out of range
  QUADRILLE_EXPORT void check() const;
};

/// Gives the surfaces and bodies of successive clouds lasting numbers, their tracks. A surface
/// keeps its number through frames in which it was not found and through changes of its detected
/// type; a body, such as a mug with its walls, also while its parts, the main one and its kind
/// change.
///
/// A track is what was last seen, with its velocity. The next detection of a surface is the one
/// onto which the most likely translation carries its patch with the least difference of shape and
/// dimensions; a body is recognised by the space that it takes. All things of one sort are assigned
/// jointly, first to the tracks that were seen in the last frame; a thing without a track begins
/// one. The same things give the same numbers.
class Tracker {
 public:
  /// @throws std::invalid_argument if an option is out of range
  QUADRILLE_EXPORT explicit Tracker(const TrackOptions& options = {});
  QUADRILLE_EXPORT ~Tracker();
  QUADRILLE_EXPORT Tracker(Tracker&&) noexcept;
  QUADRILLE_EXPORT Tracker& operator=(Tracker&&) noexcept;

  /// Sets Detection::track and SceneBody::track of all that was found in one cloud to 1, 2, … in
  /// order of appearance, surfaces before bodies. No surface and body share a number.
  ///
  /// If time runs backwards, a log has been restarted: all tracks are forgotten and numbers begin
  /// at 1.
  /// @param utime  time of the cloud [us]; equal times are one moment
  /// @param X_WC   pose of the cloud's frame in a fixed frame W; the identity for a camera at rest
  QUADRILLE_EXPORT void update(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                               DetectionResult* result);
  /// Sets Detection::track alone, for callers that have no bodies.
  QUADRILLE_EXPORT void update(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                               std::vector<Detection>* detections);

 private:
  struct Tracks;
  std::unique_ptr<Tracks> tracks_;
};

}  // namespace quadrille

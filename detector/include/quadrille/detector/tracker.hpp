#pragma once

#include <cstdint>
#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

struct SeenPatch;

struct TrackOptions {
  /// False: no detection gets a track.
  bool enabled = true;
  /// Largest difference between a track and its next detection, in standard deviations of place,
  /// shape and dimensions together.
  double gate = 4.0;
  /// How long a track is remembered while nothing is seen of it [s]; three frames in any case.
  double forget_after = 1.0;
  /// Standard deviation of the speed of what is new [m/s].
  double speed = 0.5;
  /// Standard deviation of the acceleration, of hands that move things and so on [m/s²].
  double acceleration = 1.0;
  /// Largest age of a camera's pose beside the cloud, where poses come as messages of their own
  /// [s]; what is older counts as none. The Tracker itself takes whatever pose it is given.
  double pose_age = 1.0;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

/// Calls visit(name, field) for each setting, as visit_options() does for the detector's.
template <class Options, class Visitor>
void visit_track_options(Options& o, Visitor&& visit) {
  visit("track.enabled", o.enabled);
  visit("track.gate", o.gate);
  visit("track.forget_after", o.forget_after);
  visit("track.speed", o.speed);
  visit("track.acceleration", o.acceleration);
  visit("track.pose_age", o.pose_age);
}

/// Gives the detections of successive clouds ids that last: one surface, one id, through frames in
/// which it was not found and whatever type it was given.
///
/// A track is the patch of surface that was last seen, with its velocity. The next detection is
/// the one that the patch is carried onto by the most likely translation, with the least difference
/// of shape and dimensions; all are assigned at once, those first that were just seen. What is
/// assigned to none begins a track. The same detections give the same ids.
class Tracker {
 public:
  /// @throws std::invalid_argument if an option is out of range
  explicit Tracker(const TrackOptions& options = {});
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  /// Sets Detection::track of the detections of one cloud, 1, 2, … in order of appearance.
  ///
  /// If time runs backwards, a log has been started again: all is forgotten, and ids begin with 1.
  /// @param utime  time of the cloud [us]; equal times are one moment
  /// @param X_WC   pose of the cloud's frame in a fixed frame W; the identity for a camera at rest
  void update(std::int64_t utime, const Eigen::Isometry3d& X_WC,
              std::vector<Detection>* detections);

 private:
  struct Track;
  struct Pairing;

  void advance(double seconds);
  Pairing compare(const Track& track, const Detection& detection, const SeenPatch& patch) const;
  void pair_those(bool just_seen, const std::vector<SeenPatch>& patches,
                  std::vector<Detection>* detections);
  void renew(const Detection& detection, const SeenPatch& patch, const Eigen::Vector3d& shift_W,
             Track* track) const;
  void begin(const SeenPatch& patch, Detection* detection);

  TrackOptions options_;
  std::vector<Track> tracks_;
  int last_id_ = 0;
  std::int64_t utime_ = 0;
};

}  // namespace quadrille

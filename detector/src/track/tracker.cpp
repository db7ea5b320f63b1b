#include "quadrille/detector/tracker.hpp"

#include <cstddef>
#include <vector>

#include "track/body_look.hpp"
#include "track/surface_look.hpp"
#include "track/track_list.hpp"

namespace quadrille {
namespace {

/// Gives each thing its track.
/// @param X_WC     pose of the things' frame in the fixed frame
/// @param last_id  the last number that was given, counted up for those that are new
template <class Look, class Thing>
void set_tracks(const Eigen::Isometry3d& X_WC, TrackList<Look>* tracks, int* last_id,
                std::vector<Thing>* things) {
  std::vector<Look> looks;
  for (const Thing& thing : *things) looks.push_back(look_of(thing, X_WC));
  const std::vector<int> ids = tracks->recognise(looks, last_id);
  for (std::size_t i = 0; i < things->size(); ++i) (*things)[i].track = ids[i];
}

}  // namespace

void TrackOptions::check() const { check_ranges(*this); }

struct Tracker::Tracks {
  explicit Tracks(const TrackOptions& o) : options(o), surfaces(o), bodies(o) { o.check(); }

  /// Goes on to the time of the next cloud [us].
  void go_to(std::int64_t next) {
    if (next < utime) {
      surfaces.clear();
      bodies.clear();
      last_id = 0;
    }
    // The subtraction is done in doubles, since times from hostile messages may overflow integers.
    const double seconds = 1e-6 * (static_cast<double>(next) - static_cast<double>(utime));
    surfaces.advance(seconds);
    bodies.advance(seconds);
    utime = next;
  }

  TrackOptions options;
  TrackList<SurfaceLook> surfaces;
  TrackList<BodyLook> bodies;
  /// The last number that was given to a surface or a body.
  int last_id = 0;
  std::int64_t utime = 0;
};

Tracker::Tracker(const TrackOptions& options) : tracks_(std::make_unique<Tracks>(options)) {}
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

void Tracker::update(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                     std::vector<Detection>* detections) {
  DetectionResult surfaces;
  surfaces.detections.swap(*detections);
  update(utime, X_WC, &surfaces);
  surfaces.detections.swap(*detections);
}

void Tracker::update(std::int64_t utime, const Eigen::Isometry3d& X_WC, DetectionResult* result) {
  for (Detection& detection : result->detections) detection.track = 0;
  for (SceneBody& body : result->bodies) body.track = 0;
  Tracks& tracks = *tracks_;
  if (!tracks.options.enabled) return;
  tracks.go_to(utime);
  set_tracks(X_WC, &tracks.surfaces, &tracks.last_id, &result->detections);
  set_tracks(X_WC, &tracks.bodies, &tracks.last_id, &result->bodies);
}

}  // namespace quadrille

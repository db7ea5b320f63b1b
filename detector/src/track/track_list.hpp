#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "quadrille/detector/tracker.hpp"
#include "track/assignment.hpp"
#include "track/look_match.hpp"

namespace quadrille {

/// The tracks of all things of one sort: a track is the look of a thing, with its velocity.
/// @tparam Look  with functions place_std(), translated(), renewed() and match_looks(), as
///   SurfaceLook has them
template <class Look>
class TrackList {
 public:
  explicit TrackList(const TrackOptions& options) : options_(options) {}

  void clear() { tracks_.clear(); }

  /// Moves all tracks to the next moment, and forgets those that were last seen too long ago.
  void advance(double seconds);

  /// Returns the number of each look of one cloud: that of its track, or the number after
  /// `*last_id`, which then is counted up.
  std::vector<int> recognise(const std::vector<Look>& looks, int* last_id);

 private:
  // Number of frames for which any track is remembered, and largest number of tracks: the time of
  // an assignment grows with its cube.
  static constexpr int kMinFramesKept = 3;
  static constexpr std::size_t kMaxTracks = 256;

  struct Track {
    int id = 0;
    Look look;
    Eigen::Vector3d v_W = Eigen::Vector3d::Zero();
    /// Variance of each component of the velocity [m²/s²].
    double velocity_variance = 0.0;
    double seconds_unseen = 0.0;
    int frames_unseen = 0;
    /// Number of frames since it began, and the number of these in which it was seen.
    int frames = 0, sightings = 0;
  };

  static double squared(double x) { return x * x; }
  Expectation expected_of(const Track& track) const;
  void pair_those(bool just_seen, const std::vector<Look>& looks, std::vector<int>* ids);
  void renew(const Look& look, const Eigen::Vector3d& shift_W, Track* track) const;

  TrackOptions options_;
  std::vector<Track> tracks_;
};

template <class Look>
void TrackList<Look>::advance(double seconds) {
  std::erase_if(tracks_, [&](const Track& track) {
    return track.seconds_unseen > options_.forget_after && track.frames_unseen >= kMinFramesKept;
  });
  if (tracks_.size() > kMaxTracks) {
    std::stable_sort(tracks_.begin(), tracks_.end(), [](const Track& a, const Track& b) {
      return a.frames_unseen < b.frames_unseen;
    });
    tracks_.resize(kMaxTracks);
  }
  for (Track& track : tracks_) {
    track.look = translated(std::move(track.look), seconds * track.v_W);
    track.seconds_unseen += seconds;
    ++track.frames_unseen;
    ++track.frames;
  }
}

template <class Look>
std::vector<int> TrackList<Look>::recognise(const std::vector<Look>& looks, int* last_id) {
  std::vector<int> ids(looks.size(), 0);
  pair_those(true, looks, &ids);
  pair_those(false, looks, &ids);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    if (ids[i] != 0) continue;
    Track& track = tracks_.emplace_back();
    track.id = ids[i] = ++*last_id;
    track.look = looks[i];
    track.velocity_variance = squared(options_.speed);
  }
  return ids;
}

template <class Look>
Expectation TrackList<Look>::expected_of(const Track& track) const {
  const double t = track.seconds_unseen;
  return {track.velocity_variance * t * t + squared(0.5 * options_.acceleration * t * t),
          (track.sightings + 1.0) / (track.frames + 2.0), options_.gate};
}

/// Pairs looks without a track either with the tracks that were seen in the last frame or with the
/// others. Recently seen tracks go first because their positions are known best; the region in
/// which an older track may be grows until any look fits it.
template <class Look>
void TrackList<Look>::pair_those(bool just_seen, const std::vector<Look>& looks,
                                 std::vector<int>* ids) {
  std::vector<Track*> tracks;
  for (Track& track : tracks_) {
    if (track.frames_unseen > 0 && (track.frames_unseen == 1) == just_seen) {
      tracks.push_back(&track);
    }
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    if ((*ids)[i] == 0) open.push_back(i);
  }
  std::vector<std::vector<LookMatch>> matches(tracks.size());
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(tracks.size()),
                       static_cast<Eigen::Index>(open.size()));
  for (std::size_t row = 0; row < tracks.size(); ++row) {
    for (const std::size_t i : open) {
      matches[row].push_back(match_looks(tracks[row]->look, looks[i], expected_of(*tracks[row])));
      cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(matches[row].size()) - 1) =
          matches[row].back().cost;
    }
  }
  const std::vector<int> columns = assign(cost, squared(options_.gate));
  for (std::size_t row = 0; row < tracks.size(); ++row) {
    if (columns[row] < 0) continue;
    const std::size_t i = open[static_cast<std::size_t>(columns[row])];
    (*ids)[i] = tracks[row]->id;
    renew(looks[i], matches[row][static_cast<std::size_t>(columns[row])].shift_W, tracks[row]);
  }
}

/// Updates a track with its look, and corrects its velocity by the shift (a Kalman gain).
template <class Look>
void TrackList<Look>::renew(const Look& look, const Eigen::Vector3d& shift_W, Track* track) const {
  const double t = track->seconds_unseen;
  if (t > 0.0) {
    const double expected = track->velocity_variance + squared(options_.acceleration * t);
    const double measured = (squared(place_std(track->look)) + squared(place_std(look))) / (t * t);
    const double gain = expected > 0.0 ? expected / (expected + measured) : 0.0;
    track->v_W += gain / t * shift_W;
    track->velocity_variance = (1.0 - gain) * expected;
  }
  track->look = renewed(track->look, look);
  track->seconds_unseen = 0.0;
  track->frames_unseen = 0;
  ++track->sightings;
}

}  // namespace quadrille

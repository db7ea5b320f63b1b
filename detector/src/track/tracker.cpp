#include "quadrille/detector/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "track/assignment.hpp"
#include "track/seen_patch.hpp"

namespace quadrille {
namespace {

// Number of frames for which any track is remembered, and largest number of tracks: the time of an
// assignment grows with its cube.
constexpr int kMinFramesKept = 3;
constexpr std::size_t kMaxTracks = 256;
// Standard deviation of a dimension in addition to its published one, as a share of its value:
// types and seen parts change between views.
constexpr double kDimensionShare = 0.1;
// Largest cost of one dimension, since a single wild fit does not make another object.
constexpr double kMaxDimensionCost = 4.0;
// Cost of a different type. It replaces the cost of dimensions, which cannot be compared then.
constexpr double kOtherTypeCost = 0.5;
// Standard deviations of the turn of normals [rad], and of the gap as a share of the size.
constexpr double kTurnDeviation = 0.35, kGapDeviation = 0.25;

double squared(double x) { return x * x; }

/// True if a dimension measures only the seen part and not the whole object.
bool depends_on_view(std::string_view dimension) {
  return dimension == "length" || dimension == "width" || dimension == "height";
}

/// Mean squared difference, in standard deviations, of the dimensions that both have.
double compare_dimensions(const std::vector<Dimension>& a, const std::vector<Dimension>& b) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i].name != b[i].name || depends_on_view(a[i].name)) continue;
    const double scale = kDimensionShare * std::max(std::abs(a[i].value), std::abs(b[i].value));
    const double variance = squared(a[i].std) + squared(b[i].std) + squared(scale);
    // Dimensions whose deviations could not be estimated are not compared.
    if (!std::isfinite(variance) || !(variance > 0.0)) continue;
    sum += std::min(kMaxDimensionCost, squared(a[i].value - b[i].value) / variance);
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

/// Squared difference of shapes and extents, in standard deviations.
double compare_shapes(const PatchMatch& match, const SeenPatch& a, const SeenPatch& b) {
  const double size = 0.5 * (a.size + b.size);
  const double noise = std::hypot(a.rms, b.rms, kFitShare * size);
  return squared(match.residual / noise) + squared(match.turn / kTurnDeviation) +
         squared(match.gap / (kGapDeviation * size)) + (1.0 - match.overlap);
}

}  // namespace

void TrackOptions::check() const { check_ranges(*this); }

/// State of a surface that was seen before.
struct Tracker::Track {
  int id = 0;
  QuadricType type = QuadricType::kPlane;
  std::vector<Dimension> dimensions;
  SeenPatch patch;
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();
  /// Variance of each component of the velocity [m²/s²].
  double velocity_variance = 0.0;
  double seconds_unseen = 0.0;
  int frames_unseen = 0;
};

/// A possible pairing of a track with a detection.
struct Tracker::Pairing {
  Eigen::Vector3d shift_W;
  /// Squared difference in standard deviations.
  double cost = std::numeric_limits<double>::infinity();
};

Tracker::Tracker(const TrackOptions& options) : options_(options) { options_.check(); }
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

void Tracker::update(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                     std::vector<Detection>* detections) {
  for (Detection& detection : *detections) detection.track = 0;
  if (!options_.enabled) return;
  if (utime < utime_) {
    tracks_.clear();
    last_id_ = 0;
  }
  // The subtraction is done in doubles, since times from hostile messages may overflow integers.
  advance(1e-6 * (static_cast<double>(utime) - static_cast<double>(utime_)));
  utime_ = utime;
  std::vector<SeenPatch> patches;
  for (const Detection& d : *detections) patches.push_back(seen_patch(d, X_WC));
  pair_those(true, patches, detections);
  pair_those(false, patches, detections);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if ((*detections)[i].track == 0) begin(patches[i], &(*detections)[i]);
  }
}

/// Moves all tracks to the next moment, and forgets those that were last seen too long ago.
void Tracker::advance(double seconds) {
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
    track.patch = translated(std::move(track.patch), seconds * track.v_W);
    track.seconds_unseen += seconds;
    ++track.frames_unseen;
  }
}

Tracker::Pairing Tracker::compare(const Track& track, const Detection& detection,
                                  const SeenPatch& patch) const {
  const double t = track.seconds_unseen;
  const double variance = squared(place_std(track.patch)) + squared(place_std(patch)) +
                          track.velocity_variance * t * t +
                          squared(0.5 * options_.acceleration * t * t);
  const double max_cost = squared(options_.gate);
  // A detection farther away is another surface, although a plane that slides in itself shows no
  // shift. The seen part may have moved by up to its own size.
  const double max_distance = options_.gate * std::sqrt(variance) + track.patch.size + patch.size;
  if ((patch.centre_W - track.patch.centre_W).norm() > max_distance) return {};
  const PatchMatch match = match_patches(track.patch, patch);
  const double place = match.shift_W.squaredNorm() / variance;
  if (!(place < max_cost)) return {};
  const double named = track.type == detection.type
                           ? compare_dimensions(track.dimensions, detection.dimensions)
                           : kOtherTypeCost;
  return {match.shift_W, place + compare_shapes(match, track.patch, patch) + named};
}

/// Pairs detections without a track either with the tracks that were seen in the last frame or with
/// the others. Recently seen tracks go first because their positions are known best; the region in
/// which an older track may be grows until any detection fits it.
void Tracker::pair_those(bool just_seen, const std::vector<SeenPatch>& patches,
                         std::vector<Detection>* detections) {
  std::vector<Track*> tracks;
  for (Track& track : tracks_) {
    if (track.frames_unseen > 0 && (track.frames_unseen == 1) == just_seen) {
      tracks.push_back(&track);
    }
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < detections->size(); ++i) {
    if ((*detections)[i].track == 0) open.push_back(i);
  }
  std::vector<std::vector<Pairing>> pairings(tracks.size());
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(tracks.size()),
                       static_cast<Eigen::Index>(open.size()));
  for (std::size_t row = 0; row < tracks.size(); ++row) {
    for (const std::size_t i : open) {
      pairings[row].push_back(compare(*tracks[row], (*detections)[i], patches[i]));
      cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(pairings[row].size()) - 1) =
          pairings[row].back().cost;
    }
  }
  const std::vector<int> columns = assign(cost, squared(options_.gate));
  for (std::size_t row = 0; row < tracks.size(); ++row) {
    if (columns[row] < 0) continue;
    const std::size_t i = open[static_cast<std::size_t>(columns[row])];
    (*detections)[i].track = tracks[row]->id;
    renew((*detections)[i], patches[i], pairings[row][columns[row]].shift_W, tracks[row]);
  }
}

/// Updates a track with its detection, and corrects its velocity by the shift (a Kalman gain).
void Tracker::renew(const Detection& detection, const SeenPatch& patch,
                    const Eigen::Vector3d& shift_W, Track* track) const {
  const double t = track->seconds_unseen;
  if (t > 0.0) {
    const double expected = track->velocity_variance + squared(options_.acceleration * t);
    const double measured =
        (squared(place_std(track->patch)) + squared(place_std(patch))) / (t * t);
    const double gain = expected > 0.0 ? expected / (expected + measured) : 0.0;
    track->v_W += gain / t * shift_W;
    track->velocity_variance = (1.0 - gain) * expected;
  }
  track->type = detection.type;
  track->dimensions = detection.dimensions;
  track->patch = patch;
  track->seconds_unseen = 0.0;
  track->frames_unseen = 0;
}

void Tracker::begin(const SeenPatch& patch, Detection* detection) {
  Track track;
  track.id = detection->track = ++last_id_;
  track.type = detection->type;
  track.dimensions = detection->dimensions;
  track.patch = patch;
  track.velocity_variance = squared(options_.speed);
  tracks_.push_back(std::move(track));
}

}  // namespace quadrille

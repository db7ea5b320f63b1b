#include "search/axes/coaxial.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "base/quantile.hpp"
#include "fit/posed_quadric.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "search/axes/may_meet_axis.hpp"
#include "search/axes/normal_line.hpp"
#include "search/axes/point_runs.hpp"
#include "search/axes/profile.hpp"
#include "search/axes/profile_support.hpp"
#include "search/axes/set_flags.hpp"

namespace quadrille {
namespace {

// Number of bases for each axis and side, and of pieces that are sought there at most: a bottle has
// a wall, a shoulder, a neck and a rim.
constexpr std::size_t kBases = 24;
constexpr std::size_t kMaxPieces = 6;
// Radii of bodies, in cells; see vote_for_axes().
constexpr float kMinRadius = 2.0f, kMaxRadius = 40.0f;
// Samples must span five of 36 sectors of the turn about the axis (50°). Of less, any radius fits.
constexpr int kSectors = 36, kMinSectors = 5;
// Rounds of the fit of a piece, which ends early if its support falls by more than this share.
constexpr int kRounds = 2;
constexpr float kMaxLoss = 0.1f;
// A candidate has no more than this share of its samples in common with better ones.
constexpr double kMaxShared = 0.5;

/// A profile with the points that support it.
struct Piece {
  Profile profile;
  std::vector<ProfilePoint> points;
  float support = 0.0f;
};

/// The samples whose normal lines meet an axis, by the side of the wall on which they lie: those
/// whose normals point away from the axis, and those whose normals point to it.
struct AxialSamples {
  std::vector<ProfilePoint> outer, inner;
};

AxialSamples samples_about(const Axis& axis, const Eigen::Isometry3d& X_CA,
                           const SurfaceSamples& samples, const PointRuns& runs, const Mask& free,
                           const InlierTest& test, float cell) {
  const Eigen::Isometry3f X_AC = X_CA.inverse().cast<float>();
  const Eigen::Vector3f point = axis.point.cast<float>(), direction = axis.direction.cast<float>();
  const float widest = kMaxRadius * cell, narrowest = kMinRadius * cell;
  AxialSamples about;
  const auto add = [&](int i) {
    const Eigen::Vector3f off = samples.raw[i] - point;
    const float along = direction.dot(off), square = off.squaredNorm() - along * along;
    if (square > widest * widest || square < narrowest * narrowest) return;
    const Eigen::Vector3f x = X_AC * samples.raw[i];
    const Eigen::Vector3f n = X_AC.linear() * samples.n[i];
    const NormalLine line(x, n);
    if (!line.has_direction() || !line.meets_axis(samples.cell[i])) return;
    const bool outer = line.at.dot(line.along) > 0.0f;
    const float turn = std::atan2(x.y(), x.x()) / (2.0f * std::numbers::pi_v<float>)+0.5f;
    (outer ? about.outer : about.inner)
        .push_back({i, std::sqrt(square), x.z(),
                    Eigen::Vector2f(outer ? line.sine : -line.sine, n.z()),
                    std::min(kSectors - 1, static_cast<int>(turn * kSectors)),
                    static_cast<float>(test.sigmas) * samples.sigma[i] +
                        static_cast<float>(test.cells) * samples.cell[i]});
  };
  std::array<int, PointRuns::kLength> may, list;
  runs.for_each_near(point, direction, widest, [&](int begin, int end) {
    may_meet_axis(samples, begin, end, point, direction, widest, may.data());
    const int count = list_set_flags(may.data(), end - begin, list.data());
    for (int k = 0; k < count; ++k) {
      const int i = begin + list[k];
      if (free.empty() || free[i]) add(i);
    }
  });
  return about;
}

/// Searches one side of the wall about one axis.
class PieceSearch {
 public:
  PieceSearch(const InlierTest& test, int min_samples, float max_radius)
      : test_{static_cast<float>(test.min_cosine), static_cast<std::size_t>(min_samples),
              kMinSectors},
        max_radius_(max_radius) {}

  /// The pieces of the points, each without those of the pieces before it.
  std::vector<Piece> pieces(std::vector<ProfilePoint> points) const {
    std::vector<Piece> found;
    while (found.size() < kMaxPieces && points.size() >= test_.min_points) {
      std::optional<Piece> best = best_piece(points);
      if (!best) break;
      std::erase_if(points, [&](const ProfilePoint& m) { return is_on(m, best->profile); });
      found.push_back(std::move(*best));
    }
    return found;
  }

 private:
  bool is_on(const ProfilePoint& m, const Profile& profile) const {
    return supports(m, profile, test_.min_cosine);
  }

  Piece with_points(const Profile& profile, float value,
                    const std::vector<ProfilePoint>& points) const {
    Piece piece{profile, {}, value};
    std::copy_if(points.begin(), points.end(), std::back_inserter(piece.points),
                 [&](const ProfilePoint& m) { return is_on(m, profile); });
    return piece;
  }

  std::optional<Piece> best_piece(const std::vector<ProfilePoint>& points) const {
    ProfileSupport support(points, test_);
    Profile best;
    float most = 0.0f;
    const std::size_t step = std::max<std::size_t>(1, points.size() / kBases);
    for (std::size_t k = 0; k < points.size(); k += step) {
      for (const auto& profile : {line_through(points[k]), arc_through(points[k], max_radius_)}) {
        const float value = profile ? support.of(*profile, most) : 0.0f;
        if (value > most) best = *profile, most = value;
      }
    }
    if (most <= 0.0f) return std::nullopt;
    Piece piece = with_points(best, most, points);
    for (int round = 0; round < kRounds; ++round) {
      const Profile again = fitted(piece.profile, piece.points);
      const float value = support.of(again);
      if (value < (1.0f - kMaxLoss) * piece.support) break;
      piece = with_points(again, value, points);
    }
    return piece;
  }

  SupportTest test_;
  float max_radius_;
};

Candidate candidate_of(const Piece& piece, const Eigen::Isometry3d& X_CA) {
  Candidate candidate;
  candidate.Q = revolved(piece.profile).transformed(X_CA).normalized();
  candidate.family = family_of(piece.profile);
  double sum = 0.0;
  for (const ProfilePoint& m : piece.points) {
    candidate.region.push_back(m.sample);
    const double d = piece.profile.distance(m);
    sum += d * d;
  }
  candidate.rms = std::sqrt(sum / static_cast<double>(piece.points.size()));
  return candidate;
}

}  // namespace

std::vector<Candidate> coaxial_candidates(const SurfaceSamples& samples, const Mask& free,
                                          const std::vector<Axis>& axes, const InlierTest& test,
                                          int min_samples, int threads) {
  if (samples.size() == 0) return {};
  std::vector<float> cells = samples.cell;
  const float cell = quantile(cells, 0.5);
  const PointRuns runs(samples.raw);
  const PieceSearch search(test, min_samples, kMaxRadius * cell);
  std::vector<std::vector<std::pair<float, Candidate>>> of_axes(axes.size());
  parallel_for(static_cast<int>(axes.size()), threads, [&](int k) {
    const Axis& axis = axes[k];
    const Eigen::Isometry3d X_CA = pose_along(axis.point, axis.direction);
    AxialSamples about = samples_about(axis, X_CA, samples, runs, free, test, cell);
    for (std::vector<ProfilePoint>* side : {&about.outer, &about.inner}) {
      for (const Piece& piece : search.pieces(std::move(*side))) {
        of_axes[k].emplace_back(piece.support, candidate_of(piece, X_CA));
      }
    }
  });
  std::vector<std::pair<float, Candidate>> found;
  for (auto& list : of_axes) std::move(list.begin(), list.end(), std::back_inserter(found));
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  Mask taken(static_cast<std::size_t>(samples.size()), 0);
  std::vector<Candidate> candidates;
  for (auto& [support, candidate] : found) {
    const auto shared = std::count_if(candidate.region.begin(), candidate.region.end(),
                                      [&](int i) { return taken[i] != 0; });
    if (static_cast<double>(shared) > kMaxShared * static_cast<double>(candidate.region.size())) {
      continue;
    }
    for (const int i : candidate.region) taken[i] = 1;
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

}  // namespace quadrille

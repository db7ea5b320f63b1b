#include "boxes/face_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/buckets.hpp"
#include "base/quantile.hpp"
#include "boxes/connected_pieces.hpp"
#include "boxes/onto_plane.hpp"
#include "cloud/some_points.hpp"

namespace quadrille {
namespace {

// No sensor has points that are nearer to each other, but copies of points are [m].
constexpr double kMinPitch = 1e-5;

std::array<Eigen::Vector3d, 4> corners_C(const FacePatch& patch) {
  std::array<Eigen::Vector3d, 4> corners;
  for (int n = 0; n < 4; ++n) {
    corners[n] = patch.X_CP * Eigen::Vector3d(n & 1 ? patch.half.x() : -patch.half.x(),
                                              n & 2 ? patch.half.y() : -patch.half.y(), 0.0);
  }
  return corners;
}

/// Noise along the normal, measured in the middle of the patch, where nothing else lies beside the
/// plane [m].
/// @param points  those near the plane
double noise_of(const FacePatch& patch, const std::vector<Eigen::Vector3d>& points) {
  const Eigen::Isometry3d X_PC = patch.X_CP.inverse();
  std::vector<double> off;
  off.reserve(points.size());
  for (const Eigen::Vector3d& p_C : points) {
    const Eigen::Vector3d p = X_PC * p_C;
    if ((p.head<2>().cwiseAbs().array() < 0.7 * patch.half.array()).all()) off.push_back(p.z());
  }
  return off.empty() ? 0.0 : robust_std(off);
}

/// Distance between neighbouring points across the line of sight, from the number n of points in
/// the middle half along either axis: √(area · cos θ / n), where area · cos θ / n is the area of a
/// pixel across the line of sight.
double pitch_of(const std::vector<Eigen::Vector2d>& places, double cosine) {
  Eigen::Vector2d low, high;
  for (int i = 0; i < 2; ++i) {
    std::vector<double> x(places.size());
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = places[k][i];
    low[i] = quantile(x, 0.25);
    high[i] = quantile(x, 0.75);
  }
  const auto inside = std::count_if(places.begin(), places.end(), [&](const Eigen::Vector2d& p) {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  });
  const double area = (high - low).prod();
  return std::max(kMinPitch, std::sqrt(cosine * area / std::max(1.0, double(inside))));
}

bool larger(const MeasuredFace& a, const MeasuredFace& b) {
  return a.measured_C.size() > b.measured_C.size();
}

/// All faces in a patch as one, with the place of each point in the patch.
struct PlacedPoints {
  MeasuredFace whole;
  std::vector<Eigen::Vector2d> places;
};

/// Keeps those of some points that lie on a plane and in the patch, or within a margin beside it.
PlacedPoints points_on(const Face& plane, const FacePatch& patch, double margin,
                       const std::vector<Eigen::Vector3d>& points, const DirectionIndex& sight) {
  const double tolerance = plane.tolerance();
  const Eigen::Isometry3d X_PC = patch.X_CP.inverse();
  const OntoPlane onto_plane(plane, sight);
  PlacedPoints kept{{plane, {}}, {}};
  for (const Eigen::Vector3d& p : points) {
    if (std::abs(plane.height(p)) > tolerance) continue;
    const Eigen::Vector3d on_C = onto_plane(p);
    const Eigen::Vector2d place = (X_PC * on_C).head<2>();
    if (!(place.cwiseAbs().array() < patch.half.array() + margin).all()) continue;
    kept.whole.measured_C.push_back(p);
    kept.whole.face.points_C.push_back(on_C);
    kept.places.push_back(place);
  }
  return kept;
}

/// Sets how a face is looked at and how far its points are apart.
/// @param places  those of its points in the patch
void set_pitch(Face& face, const std::vector<Eigen::Vector2d>& places,
               const DirectionIndex& sight) {
  face.set_middle();
  if (sight.single()) {
    const double along = std::abs(face.n_C.dot((face.middle_C - sight.eye()).normalized()));
    face.cosine = std::max(along, kMinCosine);
  }
  face.pitch = pitch_of(places, face.cosine);
}

/// Divides a whole into faces: its connected pieces that have enough points, in any order.
std::vector<MeasuredFace> divided(MeasuredFace whole, const std::vector<Eigen::Vector2d>& places) {
  const double gap = std::max(1e-4, kGapPitches * whole.face.pitch / whole.face.cosine);
  const std::vector<int> number = connected_pieces(places, gap);
  const Buckets numbered =
      sort_into_buckets(number, 1 + *std::max_element(number.begin(), number.end()));
  const std::vector<Eigen::Vector3d> on_C = std::exchange(whole.face.points_C, {});
  std::vector<MeasuredFace> found;
  for (int n = 0; n < numbered.size(); ++n) {
    if (numbered[n].size() < kMinPoints) continue;
    MeasuredFace& measured = found.emplace_back(MeasuredFace{whole.face, {}});
    measured.face.points_C.reserve(numbered[n].size());
    measured.measured_C.reserve(numbered[n].size());
    for (const int k : numbered[n]) {
      measured.face.points_C.push_back(on_C[k]);
      measured.measured_C.push_back(whole.measured_C[k]);
    }
    measured.face.set_middle();
  }
  return found;
}

}  // namespace

std::vector<Eigen::Vector3d> FaceFinder::points_around(const FacePatch& patch,
                                                       const Face& plane) const {
  std::vector<Eigen::Vector3d> points =
      sight_.points_towards(corners_C(patch), kMaxTolerance, limits_.max_points);
  std::erase_if(points, [&](const auto& p) { return std::abs(plane.height(p)) > kMaxTolerance; });
  return points;
}

std::vector<MeasuredFace> FaceFinder::faces_in(const FacePatch& patch,
                                               std::optional<double> sigma) const {
  Face plane;
  plane.n_C = patch.X_CP.linear().col(2);
  plane.offset = plane.n_C.dot(patch.X_CP.translation());
  const std::vector<Eigen::Vector3d> points = points_around(patch, plane);
  plane.sigma = sigma ? *sigma : std::min(noise_of(patch, points), limits_.max_sigma);
  auto [whole, places] = points_on(plane, patch, limits_.margin, points, sight_);
  if (places.size() < kMinPoints) return {};
  set_pitch(whole.face, places, sight_);
  std::vector<MeasuredFace> found = divided(std::move(whole), places);
  std::stable_sort(found.begin(), found.end(), larger);
  return found;
}

std::optional<MeasuredFace> FaceFinder::refitted(const MeasuredFace& measured,
                                                 const Eigen::Matrix3d& R_CL) const {
  std::vector<MeasuredFace> found = faces_in(patch_around(measured.measured_C, R_CL));
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

}  // namespace quadrille

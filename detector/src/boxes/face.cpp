#include "boxes/face.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/quantile.hpp"
#include "boxes/connected_pieces.hpp"
#include "samples/height_fit.hpp"

namespace quadrille {
namespace {

// A detection's extent ends short of the plane's edges: points up to this far beside it may belong
// to it. Points this near to the plane are used to measure its noise [m].
constexpr double kBeside = 0.015;
// Points within this many standard deviations lie on a plane; the tolerance is clamped to these
// limits [m].
constexpr double kSigmas = 3.0, kMinTolerance = 0.002, kMaxTolerance = 0.015;
// Points no farther apart than this many pitches belong to one piece.
constexpr double kGapPitches = 2.5;
// A piece has at least this many points, and this share of the plane's points.
constexpr std::size_t kMinPoints = 40;
constexpr double kMinShare = 0.05;
// Neighbouring points share their noise, so that this many count as one independent measurement.
constexpr double kPointsPerMeasurement = 16.0;
// Least cosine between a line of sight and a normal for which their intersection is used; it also
// limits how far pitches are stretched.
constexpr double kMinCosine = 0.1;
// Converts the median of absolute deviations to the standard deviation of normal noise.
constexpr double kMedianToSigma = 1.4826;
// Share of the points that reach() cuts off at either end.
constexpr double kTrimmed = 0.01;
// This many points suffice for reach().
constexpr std::size_t kMaxReachPoints = 2000;

std::array<Eigen::Vector3d, 4> corners_C(const FacePatch& patch) {
  std::array<Eigen::Vector3d, 4> corners;
  for (int n = 0; n < 4; ++n) {
    corners[n] = patch.X_CP * Eigen::Vector3d(n & 1 ? patch.half.x() : -patch.half.x(),
                                              n & 2 ? patch.half.y() : -patch.half.y(), 0.0);
  }
  return corners;
}

FacePatch patch_of(const Detection& plane) {
  FacePatch patch{plane.X_CQ, 0.5 * plane.extent_Q.sizes().head<2>()};
  Eigen::Vector3d middle_Q = plane.extent_Q.center();
  middle_Q.z() = 0.0;
  patch.X_CP.translation() = plane.X_CQ * middle_Q;
  if (outward_normal(plane).dot(patch.X_CP.linear().col(2)) < 0.0) {
    patch.X_CP.linear().col(1) *= -1.0;
    patch.X_CP.linear().col(2) *= -1.0;
  }
  return patch;
}

/// The least-squares plane of some points, whose normal and axes are turned nearly as those of
/// another patch.
FacePatch patch_of(const std::vector<Eigen::Vector3d>& points, const FacePatch& like) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) S += (p - mean) * (p - mean).transpose();
  Eigen::Vector3d n = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(S).eigenvectors().col(0);
  if (n.dot(like.X_CP.linear().col(2)) < 0.0) n = -n;
  const Eigen::Vector3d y = n.cross(like.X_CP.linear().col(0)).normalized();
  FacePatch patch;
  patch.X_CP.linear() << y.cross(n), y, n;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) {
    box.extend(Eigen::Vector3d(patch.X_CP.linear().transpose() * p));
  }
  Eigen::Vector3d middle = box.center();
  middle.z() = n.dot(mean);
  patch.X_CP.translation() = patch.X_CP.linear() * middle;
  patch.half = 0.5 * box.sizes().head<2>();
  return patch;
}

/// Noise along the normal, measured in the middle of the patch, where nothing else lies beside the
/// plane [m].
double noise_of(const FacePatch& patch, const std::vector<Eigen::Vector3d>& points) {
  const Eigen::Isometry3d X_PC = patch.X_CP.inverse();
  std::vector<double> off;
  for (const Eigen::Vector3d& p_C : points) {
    const Eigen::Vector3d p = X_PC * p_C;
    if (std::abs(p.z()) < kBeside &&
        (p.head<2>().cwiseAbs().array() < 0.7 * patch.half.array()).all()) {
      off.push_back(std::abs(p.z()));
    }
  }
  return off.empty() ? 0.0 : kMedianToSigma * median(off);
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
  return std::sqrt(cosine * area / std::max(1.0, double(inside)));
}

/// Sets the middle and the radius of the points.
void set_middle(Face& face) {
  face.middle_C.setZero();
  for (const Eigen::Vector3d& p : face.points_C) face.middle_C += p;
  face.middle_C /= static_cast<double>(face.points_C.size());
  face.radius = 0.0;
  for (const Eigen::Vector3d& p : face.points_C) {
    face.radius = std::max(face.radius, (p - face.middle_C).norm());
  }
}

/// Standard deviation of the normal: n points with noise σ, whose least variance within the plane
/// is λ², determine it to σ/√(n λ²) [rad].
double deviation_of_normal(const Face& face) {
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : face.points_C)
    S += (p - face.middle_C) * (p - face.middle_C).transpose();
  const double n = static_cast<double>(face.points_C.size());
  // The points have no spread along the normal, so trace and minors determine the other two
  // eigenvalues.
  const double trace = S.trace() / n;
  const double minors = 0.5 * (trace * trace - (S / n).squaredNorm());
  const double least =
      0.5 * trace - std::sqrt(std::max(0.0, 0.25 * trace * trace - std::max(0.0, minors)));
  return face.sigma / std::sqrt(std::max(1e-12, n / kPointsPerMeasurement * least));
}

}  // namespace

Eigen::Vector3d outward_normal(const Detection& plane) {
  const Eigen::Vector3d z_C = plane.X_CQ.linear().col(2);
  return plane.Q_C.gradient(plane.X_CQ.translation()).dot(z_C) < 0.0 ? Eigen::Vector3d(-z_C) : z_C;
}

double Face::tolerance() const { return std::clamp(kSigmas * sigma, kMinTolerance, kMaxTolerance); }

Eigen::Vector3d Face::on_plane(const Eigen::Vector3d& p_C, const DirectionIndex& sight) const {
  if (sight.single()) {
    const Eigen::Vector3d ray = p_C - sight.eye();
    const double fall = n_C.dot(ray);
    if (std::abs(fall) > kMinCosine * ray.norm()) {
      return sight.eye() - ray * (height(sight.eye()) / fall);
    }
  }
  return p_C - height(p_C) * n_C;
}

double Face::pitch_along(const Eigen::Vector3d& u_C, const DirectionIndex& sight) const {
  if (!sight.single()) return pitch;
  const double along = u_C.dot((middle_C - sight.eye()).normalized());
  return pitch / std::max(kMinCosine, std::sqrt(std::max(0.0, 1.0 - along * along)));
}

std::pair<double, double> Face::reach(const Eigen::Vector3d& u_C) const {
  const std::size_t stride = 1 + points_C.size() / kMaxReachPoints;
  std::vector<double> x;
  x.reserve(points_C.size() / stride + 1);
  for (std::size_t k = 0; k < points_C.size(); k += stride) x.push_back(u_C.dot(points_C[k]));
  const double low = quantile(x, kTrimmed);
  return {low, quantile(x, 1.0 - kTrimmed)};
}

namespace {

/// A connected piece of a patch as a face, together with its points as they were measured.
struct Piece {
  Face face;
  std::vector<Eigen::Vector3d> measured_C;
};

bool larger(const Piece& a, const Piece& b) { return a.measured_C.size() > b.measured_C.size(); }

/// Largest departure from the plane of a quadratic that is fitted to the heights of a piece's
/// points [m].
double bend_of(const Piece& piece, const FacePatch& patch) {
  const Eigen::Matrix3d R_PC = patch.X_CP.linear().transpose();
  HeightFit fit;
  Eigen::Vector2d half = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p_C : piece.measured_C) {
    const Eigen::Vector2d place = (R_PC * (p_C - piece.face.middle_C)).head<2>();
    half = half.cwiseMax(place.cwiseAbs());
    fit.add(place.x(), place.y(), piece.face.height(p_C));
  }
  const HeightFit::Vector6 a = fit.factor().solve(fit.b);
  return std::max({std::abs(a[3]) * half.x() * half.x(), std::abs(a[4]) * half.prod(),
                   std::abs(a[5]) * half.y() * half.y()});
}

/// The pieces of a patch, the largest first.
/// @param sigma  noise of the points [m]; measured if not given
std::vector<Piece> pieces_of(const FacePatch& patch, std::optional<double> sigma,
                             const DirectionIndex& sight) {
  Face whole;
  whole.n_C = patch.X_CP.linear().col(2);
  whole.offset = whole.n_C.dot(patch.X_CP.translation());
  const std::vector<Eigen::Vector3d> points = sight.points_towards(corners_C(patch), kBeside);
  whole.sigma = sigma ? *sigma : noise_of(patch, points);

  const Eigen::Isometry3d X_PC = patch.X_CP.inverse();
  std::vector<Eigen::Vector3d> measured_C;
  std::vector<Eigen::Vector2d> places;
  for (const Eigen::Vector3d& p : points) {
    if (std::abs(whole.height(p)) > whole.tolerance()) continue;
    const Eigen::Vector3d on_C = whole.on_plane(p, sight);
    const Eigen::Vector2d place = (X_PC * on_C).head<2>();
    if (!(place.cwiseAbs().array() < patch.half.array() + kBeside).all()) continue;
    measured_C.push_back(p);
    whole.points_C.push_back(on_C);
    places.push_back(place);
  }
  if (places.size() < kMinPoints) return {};
  set_middle(whole);
  if (sight.single()) {
    const double along = std::abs(whole.n_C.dot((whole.middle_C - sight.eye()).normalized()));
    whole.cosine = std::max(along, kMinCosine);
  }
  whole.pitch = pitch_of(places, whole.cosine);
  const double gap = std::max(1e-4, kGapPitches * whole.pitch / whole.cosine);
  const std::vector<int> number = connected_pieces(places, gap);

  std::map<int, Piece> numbered;
  for (std::size_t k = 0; k < places.size(); ++k) {
    Piece& piece = numbered[number[k]];
    piece.face.points_C.push_back(whole.points_C[k]);
    piece.measured_C.push_back(measured_C[k]);
  }
  whole.points_C.clear();
  const std::size_t min_points = std::max(
      kMinPoints, static_cast<std::size_t>(kMinShare * static_cast<double>(places.size())));
  std::vector<Piece> pieces;
  for (auto& [n, piece] : numbered) {
    if (piece.measured_C.size() < min_points) continue;
    std::vector<Eigen::Vector3d> points_C = std::move(piece.face.points_C);
    piece.face = whole;
    piece.face.points_C = std::move(points_C);
    set_middle(piece.face);
    piece.face.normal_std = deviation_of_normal(piece.face);
    piece.face.bend = bend_of(piece, patch);
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(), larger);
  return pieces;
}

/// The largest piece of the patch that is fitted to a piece's own points.
std::optional<Face> refitted(const Piece& piece, const FacePatch& patch,
                             const DirectionIndex& sight) {
  std::vector<Piece> pieces = pieces_of(patch_of(piece.measured_C, patch), {}, sight);
  if (pieces.empty()) return std::nullopt;
  return std::move(pieces.front().face);
}

}  // namespace

std::optional<Face> face_at(const FacePatch& patch, double sigma, const DirectionIndex& sight) {
  const std::vector<Piece> pieces = pieces_of(patch, sigma, sight);
  if (pieces.empty()) return std::nullopt;
  return refitted(pieces.front(), patch, sight);
}

std::vector<Face> faces_of(const Detection& plane, const DirectionIndex& sight) {
  const FacePatch patch = patch_of(plane);
  std::vector<Piece> pieces = pieces_of(patch, {}, sight);
  std::vector<Face> faces;
  for (Piece& piece : pieces) {
    // If a plane has several pieces, each has a plane of its own, and the common plane is only
    // their mean.
    const auto own = pieces.size() > 1 ? refitted(piece, patch, sight) : std::nullopt;
    faces.push_back(own ? *own : std::move(piece.face));
    faces.back().id = plane.id;
    faces.back().score = plane.score;
  }
  return faces;
}

}  // namespace quadrille

#include "boxes/face.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/buckets.hpp"
#include "base/quantile.hpp"
#include "base/symmetric_eigen.hpp"
#include "boxes/connected_pieces.hpp"
#include "boxes/onto_plane.hpp"
#include "cloud/some_points.hpp"
#include "samples/height_fit.hpp"

namespace quadrille {
namespace {

// Least tolerance of a face [m].
constexpr double kMinTolerance = 0.002;
// Share of the points that reach() cuts off at either end.
constexpr double kTrimmed = 0.01;
// The normal of a face that was not detected as a plane turns across it by no more than this [rad].
// Worn boxes bulge; the strip of a cylinder that passes for a plane turns by .7 or more.
constexpr double kMaxTurn = 0.5;
// A face is fitted at most so often to the points that its last fit explains, as long as its area
// grows by this factor.
constexpr int kMaxRefits = 6;
constexpr double kMinGrowth = 1.1;
// A face is at most this many times as noisy as what it grows from. If it grows onto a neighbour,
// the step between them passes for noise, and the face swallows whatever lies near.
constexpr double kMaxNoise = 2.0;
// So many points in and around a patch suffice to tell how far it grows and whether it bends.
constexpr std::size_t kDraftPoints = 1500;
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
  return std::sqrt(cosine * area / std::max(1.0, double(inside)));
}

/// Sets the middle and the radius of the points.
void set_middle(Face& face) {
  face.middle_C.setZero();
  for (const Eigen::Vector3d& p : face.points_C) face.middle_C += p;
  face.middle_C /= static_cast<double>(face.points_C.size());
  double farthest = 0.0;
  for (const Eigen::Vector3d& p : face.points_C) {
    farthest = std::max(farthest, (p - face.middle_C).squaredNorm());
  }
  face.radius = std::sqrt(farthest);
}

}  // namespace

FacePatch patch_around(const std::vector<Eigen::Vector3d>& points, const Eigen::Matrix3d& R_CL) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) S += (p - mean) * (p - mean).transpose();
  Eigen::Vector3d n = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(S).eigenvectors().col(0);
  if (n.dot(R_CL.col(2)) < 0.0) n = -n;
  FacePatch patch;
  const Eigen::Vector3d y = n.cross(R_CL.col(0)).normalized();
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

Eigen::Vector3d outward_normal(const Detection& plane) {
  const Eigen::Vector3d z_C = plane.X_CQ.linear().col(2);
  return plane.Q_C.gradient(plane.X_CQ.translation()).dot(z_C) < 0.0 ? Eigen::Vector3d(-z_C) : z_C;
}

double Face::tolerance() const { return std::clamp(3.0 * sigma, kMinTolerance, kMaxTolerance); }

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

/// Area that the points stand for, however far they are thinned [m²].
double area_of(const Face& face) {
  return static_cast<double>(face.points_C.size()) * face.pitch * face.pitch / face.cosine;
}

/// The pieces of a patch, the largest first.
/// @param sigma       noise of the points [m]; measured if not given
/// @param max_sigma   the most that the measured noise may be [m]
/// @param max_points  number of points looked at
std::vector<Piece> pieces_of(const FacePatch& patch, std::optional<double> sigma,
                             const DirectionIndex& sight, std::size_t max_points = kMaxPoints,
                             double max_sigma = kMaxTolerance) {
  Face whole;
  whole.n_C = patch.X_CP.linear().col(2);
  whole.offset = whole.n_C.dot(patch.X_CP.translation());
  std::vector<Eigen::Vector3d> points =
      sight.points_towards(corners_C(patch), kMaxTolerance, max_points);
  std::erase_if(points, [&](const auto& p) { return std::abs(whole.height(p)) > kMaxTolerance; });
  whole.sigma = sigma ? *sigma : std::min(noise_of(patch, points), max_sigma);
  const double tolerance = whole.tolerance();

  const Eigen::Isometry3d X_PC = patch.X_CP.inverse();
  const OntoPlane onto_plane(whole, sight);
  std::vector<Eigen::Vector3d> measured_C;
  std::vector<Eigen::Vector2d> places;
  for (const Eigen::Vector3d& p : points) {
    if (std::abs(whole.height(p)) > tolerance) continue;
    const Eigen::Vector3d on_C = onto_plane(p);
    const Eigen::Vector2d place = (X_PC * on_C).head<2>();
    if (!(place.cwiseAbs().array() < patch.half.array() + kMaxTolerance).all()) continue;
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

  const Buckets numbered =
      sort_into_buckets(number, 1 + *std::max_element(number.begin(), number.end()));
  const std::vector<Eigen::Vector3d> on_C = std::exchange(whole.points_C, {});
  std::vector<Piece> pieces;
  for (int n = 0; n < numbered.size(); ++n) {
    if (numbered[n].size() < kMinPoints) continue;
    Piece& piece = pieces.emplace_back(Piece{whole, {}});
    piece.face.points_C.reserve(numbered[n].size());
    piece.measured_C.reserve(numbered[n].size());
    for (const int k : numbered[n]) {
      piece.face.points_C.push_back(on_C[k]);
      piece.measured_C.push_back(measured_C[k]);
    }
    set_middle(piece.face);
  }
  std::stable_sort(pieces.begin(), pieces.end(), larger);
  return pieces;
}

/// How far the normal turns across a piece of surface [rad], by a quadratic fit to its points:
/// nearly 0 on a flat face, about 1 on the strip of a cylinder that is thin enough to pass for a
/// plane.
double turn_across(const Piece& piece) {
  const Eigen::Vector3d n = piece.face.n_C, e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  HeightFit fit;
  std::vector<Eigen::Vector2d> places;
  for (const Eigen::Vector3d& p : piece.measured_C) {
    const Eigen::Vector3d x = p - piece.face.middle_C;
    places.emplace_back(x.dot(e1), x.dot(e2));
    fit.add(places.back().x(), places.back().y(), piece.face.height(p));
  }
  const HeightFit::Vector6 a = fit.factor().solve(fit.b);
  Eigen::Matrix2d H;
  H << 2 * a[3], a[4], a[4], 2 * a[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(H);
  double turn = 0.0;
  for (int k = 0; k < 2; ++k) {
    std::vector<double> x;
    x.reserve(places.size());
    for (const Eigen::Vector2d& place : places) x.push_back(eigen.eigenvectors().col(k).dot(place));
    const double low = quantile(x, kTrimmed), width = quantile(x, 1.0 - kTrimmed) - low;
    turn = std::max(turn, std::abs(eigen.eigenvalues()[k]) * width);
  }
  return turn;
}

/// The largest piece around a piece, in the plane that is fitted to that piece.
std::optional<Piece> refitted(const Piece& piece, const Eigen::Matrix3d& R_CL,
                              const DirectionIndex& sight, std::size_t max_points = kMaxPoints,
                              double max_sigma = kMaxTolerance) {
  std::vector<Piece> pieces =
      pieces_of(patch_around(piece.measured_C, R_CL), {}, sight, max_points, max_sigma);
  if (pieces.empty()) return std::nullopt;
  return std::move(pieces.front());
}

/// The piece after it was fitted to its own points again and again, as long as it grows; nullopt
/// if there is none.
std::optional<Piece> grown(const Piece& piece, const Eigen::Matrix3d& R_CL,
                           const DirectionIndex& sight, std::size_t max_points, double max_sigma) {
  std::optional<Piece> best;
  for (int round = 0; round < kMaxRefits; ++round) {
    std::optional<Piece> next = refitted(best ? *best : piece, R_CL, sight, max_points, max_sigma);
    if (!next) break;
    if (best && area_of(next->face) < kMinGrowth * area_of(best->face)) break;
    best = std::move(next);
  }
  return best;
}

/// The face that grows from a patch; nullopt if there is none, or if it bends.
std::optional<Face> flat_face(const FacePatch& patch, double sigma, const DirectionIndex& sight,
                              std::size_t max_points) {
  const std::vector<Piece> pieces = pieces_of(patch, sigma, sight, max_points);
  if (pieces.empty()) return std::nullopt;
  std::optional<Piece> piece =
      grown(pieces.front(), patch.X_CP.linear(), sight, max_points, kMaxNoise * sigma);
  if (!piece || turn_across(*piece) > kMaxTurn) return std::nullopt;
  piece->face.is_patch = true;
  return std::move(piece->face);
}

}  // namespace

std::optional<Face> face_at(const FacePatch& patch, double sigma, const DirectionIndex& sight) {
  const std::vector<Piece> pieces = pieces_of(patch, sigma, sight);
  if (pieces.empty()) return std::nullopt;
  std::optional<Piece> piece =
      refitted(pieces.front(), patch.X_CP.linear(), sight, kMaxPoints, kMaxNoise * sigma);
  if (!piece) return std::nullopt;
  return std::move(piece->face);
}

std::optional<Face> draft_face(const FlatPatch& flat, const DirectionIndex& sight) {
  return flat_face(flat.patch, flat.sigma, sight, kDraftPoints);
}

std::optional<Face> finished_face(const Face& draft, const DirectionIndex& sight) {
  Eigen::Matrix3d R_CL;
  R_CL << draft.n_C.unitOrthogonal(), Eigen::Vector3d::Zero(), draft.n_C;
  return flat_face(patch_around(draft.points_C, R_CL), draft.sigma, sight, kMaxPoints);
}

std::vector<Face> faces_of(const Detection& plane, const DirectionIndex& sight) {
  const FacePatch patch = patch_of(plane);
  std::vector<Piece> pieces = pieces_of(patch, {}, sight);
  std::vector<Face> faces;
  for (Piece& piece : pieces) {
    // If a plane has several pieces, each has a plane of its own, and the common plane is only
    // their mean.
    auto own = pieces.size() > 1 ? refitted(piece, patch.X_CP.linear(), sight) : std::nullopt;
    faces.push_back(std::move(own ? own->face : piece.face));
    faces.back().id = plane.id;
    faces.back().score = plane.score;
  }
  return faces;
}

}  // namespace quadrille

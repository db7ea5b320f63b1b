#include "fits/type_constrained_fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "fits/axis.hpp"
#include "fits/fit_scatter.hpp"
#include "fits/simple_type_fits.hpp"
#include "fits/taubin_fit.hpp"
#include "fits/two_planes_fit.hpp"
#include "fits/type_design.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

constexpr double kTypeTolerance = 1e-9;
constexpr int kBisections = 40;
// Weight of the tangent constraints: only points count, as in Taubin's fit, while normals give axes
// and apices.
constexpr double kNoTangents = 0.0;

bool is_of(const Quadric& Q, QuadricType type) {
  using T = QuadricType;
  const T found = canonical_form(Q, kTypeTolerance).type;
  if (type == T::kEllipsoid && found == T::kSphere) return true;
  if (type == T::kEllipticCylinder && found == T::kCylinder) return true;
  if (type == T::kEllipticCone && found == T::kCone) return true;
  return found == type;
}

/// Bisects the line from a quadric to an anchor of the type, and returns the first quadric of the
/// type on it.
Quadric steer(const Quadric& from, const Quadric& anchor, QuadricType type) {
  const Vector10d a = from.normalized().coefficients();
  Vector10d b = anchor.normalized().coefficients();
  if (a.dot(b) < 0.0) b = -b;
  double wrong = 0.0, right = 1.0;
  for (int i = 0; i < kBisections; ++i) {
    const double t = 0.5 * (wrong + right);
    (is_of(Quadric(Vector10d((1.0 - t) * a + t * b)), type) ? right : wrong) = t;
  }
  return Quadric(Vector10d((1.0 - right) * a + right * b));
}

double misfit(const Scatter& scatter, const Quadric& Q) {
  return mean_misfit(scatter, Q, kNoTangents);
}

/// Signs of the quadratic part of a type's canonical form; for hyperboloids the single sign is
/// tried on each axis.
std::vector<Eigen::Vector3d> signatures(QuadricType type) {
  switch (type) {
    case QuadricType::kEllipsoid:
      return {{1, 1, 1}};
    case QuadricType::kEllipticCylinder:
      return {{1, 1, 0}};
    case QuadricType::kHyperbolicCylinder:
      return {{1, -1, 0}};
    default:
      return {{1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
  }
}

/// The best fit of the type whose quadratic part has the given frame and equal semi-axes.
std::optional<Quadric> anchor(const OrientedPointsd& points, const Eigen::Matrix3d& frame,
                              QuadricType type) {
  const Scatter scatter(points);
  std::optional<Quadric> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& signs : signatures(type)) {
    Eigen::Matrix4d M = Eigen::Matrix4d::Zero();
    M.topLeftCorner<3, 3>() = frame * signs.asDiagonal() * frame.transpose();
    Design B(10, signs[2] == 0.0 ? 4 : 5);
    B.col(0) = Quadric(M).coefficients();
    B.rightCols(B.cols() - 1).setZero();
    for (Eigen::Index k = 1; k + 1 < B.cols(); ++k) B.col(k).segment<3>(6) = frame.col(k - 1);
    B(9, B.cols() - 1) = 1.0;
    const auto Q = fit_design(scatter, B, kNoTangents);
    if (!Q || !is_of(*Q, type) || !(misfit(scatter, *Q) < least)) continue;
    least = misfit(scatter, *Q);
    best = Q;
  }
  return best;
}

Eigen::Matrix3d eigenframe(const Quadric& Q) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(Q.matrix().topLeftCorner<3, 3>()));
  return eigen.eigenvectors();
}

/// Fits a type that is an open set of quadrics: the unconstrained fit if it is of the type,
/// otherwise that fit steered towards an anchor.
std::optional<Quadric> fit_open_type(const OrientedPointsd& points,
                                     const std::optional<Quadric>& free,
                                     const Eigen::Matrix3d& frame, QuadricType type) {
  if (!free || is_of(*free, type)) return free;
  const auto goal = anchor(points, frame, type);
  if (!goal) return std::nullopt;
  return steer(*free, *goal, type);
}

std::optional<Quadric> fit_central(const OrientedPointsd& points, QuadricType type) {
  const auto free = fit_taubin(points);
  if (!free) return std::nullopt;
  return fit_open_type(points, free, eigenframe(*free), type);
}

std::optional<Quadric> fit_extruded(const OrientedPointsd& points, QuadricType type) {
  const auto axis = direction_across_normals(points);
  if (!axis) return std::nullopt;
  const auto free = fit_design(points, extrusion_design(*axis), kNoTangents);
  if (!free) return std::nullopt;
  // Moves the axis to the last column, since its eigenvalue is zero.
  Eigen::Matrix3d frame = eigenframe(*free);
  Eigen::Index last = 0;
  (frame.transpose() * *axis).cwiseAbs().maxCoeff(&last);
  frame.col(last).swap(frame.col(2));
  return fit_open_type(points, free, frame, type);
}

/// Keeps the best fit of a design that depends on a direction.
template <typename DesignOf>
struct DirectionSearch {
  const Scatter& scatter;
  QuadricType type;
  DesignOf design_of;
  double least = std::numeric_limits<double>::infinity();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  std::optional<Quadric> best = std::nullopt;

  bool offer(const Eigen::Vector3d& u) {
    const auto Q = fit_design(scatter, design_of(u), kNoTangents);
    if (!Q || !is_of(*Q, type) || !(misfit(scatter, *Q) < least)) return false;
    least = misfit(scatter, *Q), direction = u, best = Q;
    return true;
  }

  /// The direction along which a quadric fits exactly needs no search. A search would only follow
  /// the rounding of the misfit, which determines a direction to no more than its square root.
  bool is_exact() const { return least < kExactMisfit; }
};

template <typename DesignOf>
DirectionSearch(const Scatter&, QuadricType, DesignOf) -> DirectionSearch<DesignOf>;

/// The design of a (u·x)² plus linear terms across an axis.
Design parabolic_design(const Eigen::Vector3d& u, const Eigen::Vector3d& axis) {
  Design B = Design::Zero(10, 4);
  Eigen::Matrix4d square = Eigen::Matrix4d::Zero();
  square.topLeftCorner<3, 3>() = u * u.transpose();
  B.col(0) = Quadric(square).coefficients();
  B.col(1).segment<3>(6) = axis.unitOrthogonal();
  B.col(2).segment<3>(6) = axis.cross(axis.unitOrthogonal());
  B(9, 3) = 1.0;
  return B;
}

/// Finds the direction in which the conic is curved: it starts from that of the best extruded conic
/// and from a search over half a turn, which is then refined.
std::optional<Quadric> fit_parabolic_cylinder(const OrientedPointsd& points) {
  const auto axis = direction_across_normals(points);
  if (!axis) return std::nullopt;
  const Eigen::Vector3d e = axis->unitOrthogonal(), f = axis->cross(e);
  const Scatter scatter(points);
  const auto conic = fit_design(scatter, extrusion_design(*axis), kNoTangents);
  if (!conic) return std::nullopt;
  DirectionSearch search{scatter, QuadricType::kParabolicCylinder,
                         [&](const Eigen::Vector3d& u) { return parabolic_design(u, *axis); }};
  const Eigen::Matrix3d frame = eigenframe(*conic);
  for (int k = 0; k < 3; ++k) search.offer(frame.col(k));
  if (search.is_exact()) return search.best;
  double step = std::numbers::pi / 36.0, from = 0.0;
  int count = 36;
  for (int level = 0; level < 12; ++level) {
    for (int i = 0; i < count; ++i) {
      const double angle = from + i * step;
      search.offer(std::cos(angle) * e + std::sin(angle) * f);
    }
    if (!search.best) return std::nullopt;
    from = std::atan2(search.direction.dot(f), search.direction.dot(e)) - step;
    step /= 5.0, count = 11;
  }
  return search.best;
}

/// Finds the axis by a pattern search that starts from the best direction on a coarse hemisphere,
/// or from the axis of Taubin's fit if that is better. From 9 points the misfit has several minima,
/// and the hemisphere alone often leads to a wrong one.
std::optional<Quadric> fit_paraboloid(const OrientedPointsd& points, QuadricType type) {
  const auto free = fit_taubin(points);
  if (!free) return std::nullopt;
  const Scatter scatter(points);
  DirectionSearch search{scatter, type, paraboloid_design};
  const Eigen::Matrix3d frame = eigenframe(*free);
  for (int k = 0; k < 3; ++k) search.offer(frame.col(k));
  if (search.is_exact()) return search.best;
  constexpr int kRings = 6, kSectors = 12;
  for (int ring = 0; ring <= kRings; ++ring) {
    for (int sector = 0; sector < (ring == 0 ? 1 : kSectors); ++sector) {
      const double polar = 0.5 * std::numbers::pi * ring / kRings,
                   turn = 2.0 * std::numbers::pi * sector / kSectors;
      search.offer(
          {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)});
    }
  }
  if (!search.best) return std::nullopt;
  for (double step = 0.1; step > 1e-10 && !search.is_exact();) {
    const Eigen::Vector3d u = search.direction, e = u.unitOrthogonal(), f = u.cross(e);
    bool better = false;
    for (const Eigen::Vector3d& side : {e, f, Eigen::Vector3d(-e), Eigen::Vector3d(-f)}) {
      better = search.offer((u + step * side).normalized()) || better;
    }
    if (!better) step *= 0.5;
  }
  return search.best;
}

std::optional<Quadric> fit_elliptic_cone(const OrientedPointsd& points) {
  const auto apex = common_point_of_planes(points);
  if (!apex || !(apex->norm() < 1e3)) return std::nullopt;
  const auto Q = fit_design(points, elliptic_cone_design(*apex), kNoTangents);
  return Q && is_of(*Q, QuadricType::kEllipticCone) ? Q : std::nullopt;
}

std::optional<Quadric> fit_normalised(const OrientedPointsd& points, QuadricType type) {
  using T = QuadricType;
  switch (type) {
    case T::kEllipticCylinder:
    case T::kHyperbolicCylinder:
      return fit_extruded(points, type);
    case T::kParabolicCylinder:
      return fit_parabolic_cylinder(points);
    case T::kEllipticParaboloid:
    case T::kHyperbolicParaboloid:
      return fit_paraboloid(points, type);
    case T::kEllipticCone:
      return fit_elliptic_cone(points);
    default:
      return fit_central(points, type);
  }
}

}  // namespace

std::optional<Quadric> fit_of_type(const OrientedPointsd& points, QuadricType type) {
  using T = QuadricType;
  if (is_imaginary(type)) throw std::invalid_argument("fit_of_type: the type is imaginary");
  const bool flat = type == T::kPlane || type == T::kCoincidentPlanes;
  const auto normalised = normalise(points, 9, flat ? Spread::kPlane : Spread::kSpace);
  if (!normalised) return std::nullopt;
  if (flat) return fit_plane(points);
  if (type == T::kParallelPlanes || type == T::kIntersectingPlanes) return fit_two_planes(points);
  if (type == T::kSphere) return fit_sphere(points, {kNoTangents});
  if (type == T::kCylinder) return fit_cylinder(points, {kNoTangents});
  if (type == T::kCone) return fit_cone(points, {kNoTangents});
  const auto Q = fit_normalised(normalised->data, type);
  if (!Q) return std::nullopt;
  return normalised->undo(*Q);
}

}  // namespace quadrille

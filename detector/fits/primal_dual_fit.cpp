#include "fits/primal_dual_fit.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "fits/linear_system.hpp"
#include "fits/polynomial.hpp"

namespace quadrille {
namespace {

// Largest shift of a null vector that rounding of the coordinates may cause.
constexpr double kMaxShift = 5e-8;
// The cubic's coefficients are sums of products of three coordinates of null vectors, which cancel.
// Of random pencils some in 10,000 have errors ten times as large as these. Whether two roots are
// one is decided with a further margin, since distinct roots are hardly ever so near.
constexpr double kNoiseFactor = 50.0, kMargin = 20.0;
// Errors of 1e-9 split a double root by 3e-5.
constexpr double kSplit = 1e-4;

using SystemSvd = Eigen::JacobiSVD<Eigen::MatrixXd>;

/// True if the singular vectors after the given number of values span the null space. Rounding
/// turns them by its share of the last of these values.
bool has_rank(const SystemSvd& svd, Eigen::Index rank, const NormalisedPoints& points) {
  const auto& values = svd.singularValues();
  return kMaxShift * values[rank - 1] > points.rounding() * values[0];
}

/// The plane Π in the coordinates of the unit ball, with a unit normal.
Eigen::Vector4d normalised_plane(const Normalisation& local, const Eigen::Vector4d& plane) {
  Eigen::Vector4d result;
  result << local.scale * plane.head<3>(), plane.dot(local.centre.homogeneous());
  return result / result.head<3>().norm();
}

/// The coefficients of the cubic Πᵀ adj(Q₁ + s Q₂) Π in s, interpolated from four values.
std::array<double, 4> tangency(const Quadric& Q1, const Quadric& Q2, const Eigen::Vector4d& plane) {
  Eigen::Matrix4d vandermonde;
  Eigen::Vector4d values;
  const std::array<double, 4> places = {-1.0, -0.4, 0.4, 1.0};
  for (int k = 0; k < 4; ++k) {
    const double s = places[k];
    const Quadric Q(Eigen::Matrix4d(Q1.matrix() + s * Q2.matrix()));
    values[k] = plane.dot(Q.dual() * plane);
    vandermonde.row(k) << 1.0, s, s * s, s * s * s;
  }
  const Eigen::Vector4d c = vandermonde.fullPivLu().solve(values);
  return {c[0], c[1], c[2], c[3]};
}

/// Turns a pencil such that Q₂ is far from touching the plane, and no root of the cubic near
/// infinity.
void turn_from(const Eigen::Vector4d& plane, Quadric& Q1, Quadric& Q2) {
  constexpr int kTurns = 8;
  const Eigen::Matrix4d A = Q1.matrix(), B = Q2.matrix();
  double most = -1.0;
  for (int k = 0; k < kTurns; ++k) {
    const double angle = std::numbers::pi * k / kTurns, c = std::cos(angle), s = std::sin(angle);
    const Quadric member(Eigen::Matrix4d(c * A + s * B));
    const double value = std::abs(plane.dot(member.dual() * plane));
    if (!(value > most)) continue;
    most = value, Q2 = member, Q1 = Quadric(Eigen::Matrix4d(s * A - c * B));
  }
}

/// The real roots of the cubic, where two that rounding cannot tell from a double root are replaced
/// by it, and one that rounding made complex is added. Cones and cylinders are double roots: their
/// dual has rank 1. None if rounding could move a root by more than kMaxShift.
std::vector<double> tangent_members(const std::vector<double>& cubic, double noise) {
  std::vector<double> roots = real_roots(cubic), twofold;
  for (const double twice : double_roots(cubic, kMargin * noise)) {
    const auto belongs = [&](double root) {
      return std::abs(root - twice) < kSplit * (1.0 + std::abs(twice));
    };
    // If all three roots of the cubic are known, a distant extremum is none.
    if (roots.size() > 1 && std::none_of(roots.begin(), roots.end(), belongs)) continue;
    roots.erase(std::remove_if(roots.begin(), roots.end(), belongs), roots.end());
    twofold.push_back(twice);
  }
  const double largest = Eigen::Vector4d::Map(cubic.data()).cwiseAbs().maxCoeff();
  const auto moved_by = [&](double root, double slope) {
    const double size = std::max(1.0, std::abs(root));
    return noise * largest * size * size * size / std::abs(slope);
  };
  for (const double s : roots) {
    if (!(moved_by(s, cubic[1] + s * (2.0 * cubic[2] + 3.0 * s * cubic[3])) < kMaxShift)) return {};
  }
  for (const double s : twofold) {
    if (!(moved_by(s, 2.0 * cubic[2] + 6.0 * s * cubic[3]) < kMaxShift)) return {};
  }
  roots.insert(roots.end(), twofold.begin(), twofold.end());
  return roots;
}

}  // namespace

std::optional<Quadric> fit_primal_dual(const OrientedPointsd& points, const PrimalDual& kind) {
  if (kind.planes > kind.points || kind.points + 2 * kind.planes < 9) {
    throw std::invalid_argument("fit_primal_dual: too few constraints or too many planes");
  }
  if (points.size() < kind.points) return std::nullopt;
  const auto normalised = normalise(points.first(kind.points), kind.points, Spread::kSpace);
  if (!normalised) return std::nullopt;
  Eigen::MatrixXd A(kind.points + 2 * kind.planes, 10);
  for (int i = 0; i < kind.points; ++i) A.row(i) = monomials(normalised->data.points.col(i));
  for (int i = 0; i < kind.planes; ++i) {
    const Eigen::Vector3d n = normalised->data.normals.col(i), t = n.unitOrthogonal();
    const auto G = monomial_gradients(normalised->data.points.col(i));
    A.row(kind.points + 2 * i) = t.transpose() * G;
    A.row(kind.points + 2 * i + 1) = n.cross(t).transpose() * G;
  }
  const SystemSvd svd(A, Eigen::ComputeFullV);
  if (!has_rank(svd, 9, *normalised)) return std::nullopt;
  const auto Q = normalised->undo(Quadric(Vector10d(svd.matrixV().col(9))));
  if (!Q) return std::nullopt;
  return oriented(*Q, points);
}

std::vector<Quadric> fit_eight_points_and_plane(const Eigen::Matrix3Xd& points,
                                                const Eigen::Vector4d& plane) {
  if (points.cols() != 8) {
    throw std::invalid_argument("fit_eight_points_and_plane: not eight points");
  }
  OrientedPointsd data(8);
  data.points = points;
  data.normals.setConstant(1.0);
  const auto normalised = normalise(data, 8, Spread::kSpace);
  if (!normalised || !plane.allFinite() || !(plane.head<3>().norm() > 0.0)) return {};
  Eigen::MatrixXd A(8, 10);
  for (int i = 0; i < 8; ++i) A.row(i) = monomials(normalised->data.points.col(i));
  const SystemSvd svd(A, Eigen::ComputeFullV);
  if (!has_rank(svd, 8, *normalised)) return {};
  Quadric Q1(Vector10d(svd.matrixV().col(8))), Q2(Vector10d(svd.matrixV().col(9)));
  const Eigen::Vector4d touched = normalised_plane(normalised->local, plane);
  turn_from(touched, Q1, Q2);
  const auto cubic = tangency(Q1, Q2, touched);
  const double noise =
      kNoiseFactor * normalised->rounding() * svd.singularValues()[0] / svd.singularValues()[7];
  // Q₂ touches the plane least of all.
  if (!(std::abs(cubic[3]) > noise)) return {};
  std::vector<Quadric> solutions;
  for (const double s : tangent_members({cubic.begin(), cubic.end()}, noise)) {
    const auto Q = normalised->undo(Quadric(Eigen::Matrix4d(Q1.matrix() + s * Q2.matrix())));
    if (Q) solutions.push_back(*Q);
  }
  return solutions;
}

}  // namespace quadrille

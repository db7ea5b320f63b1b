#include "fits/primal_dual_fit.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <stdexcept>

#include "fits/linear_system.hpp"
#include "fits/polynomial.hpp"

namespace quadrille {
namespace {

// Singular values below this share of the largest count as zero.
constexpr double kMinSingularShare = 1e-9;

using SystemSvd = Eigen::JacobiSVD<Eigen::MatrixXd>;

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
  if (!(svd.singularValues()[8] > kMinSingularShare * svd.singularValues()[0])) return std::nullopt;
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
  if (!(svd.singularValues()[7] > kMinSingularShare * svd.singularValues()[0])) return {};
  const Quadric Q1(Vector10d(svd.matrixV().col(8))), Q2(Vector10d(svd.matrixV().col(9)));
  const auto cubic = tangency(Q1, Q2, normalised_plane(normalised->local, plane));
  std::vector<Quadric> solutions;
  for (const double s : real_roots({cubic.begin(), cubic.end()})) {
    const auto Q = normalised->undo(Quadric(Eigen::Matrix4d(Q1.matrix() + s * Q2.matrix())));
    if (Q) solutions.push_back(*Q);
  }
  return solutions;
}

}  // namespace quadrille

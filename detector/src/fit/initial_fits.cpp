#include "fit/initial_fits.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace quadrille {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix10d = Eigen::Matrix<double, 10, 10>;

/// Pose at a position with its z axis along a direction.
Eigen::Isometry3d pose_along(const Eigen::Vector3d& position, const Eigen::Vector3d& z) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z).toRotationMatrix();
  X.translation() = position;
  return X;
}

Eigen::Matrix4d diagonal(double a, double b, double c, double d) {
  return Eigen::Vector4d(a, b, c, d).asDiagonal();
}

Eigen::Matrix3d sum_of_nn(const FitPoints& p) {
  Eigen::Matrix<float, Eigen::Dynamic, 3> N(p.size(), 3);
  N << p.nx.matrix(), p.ny.matrix(), p.nz.matrix();
  return (N.transpose() * N).cast<double>();
}

Eigen::Matrix3d sum_of_xx(const FitPoints& p) {
  Eigen::Matrix<float, Eigen::Dynamic, 3> X(p.size(), 3);
  X << p.x.matrix(), p.y.matrix(), p.z.matrix();
  return (X.transpose() * X).cast<double>();
}

Eigen::Vector3d mean_x(const FitPoints& p) {
  return Eigen::Vector3f(p.x.mean(), p.y.mean(), p.z.mean()).cast<double>();
}

Eigen::Vector3d mean_n(const FitPoints& p) {
  return Eigen::Vector3f(p.nx.mean(), p.ny.mean(), p.nz.mean()).cast<double>();
}

/// λ₁x² + λ₂y² + 2 b·x + j in the eigenvectors' frame, least eigenvalue last and left out.
struct PrincipalFrame {
  Eigen::Matrix3d R;
  Eigen::Vector3d b;
  double l1, l2, j;
};

PrincipalFrame principal_frame(const PosedQuadric& q) {
  const Eigen::Matrix4d Q = q.matrix();
  const Eigen::Matrix3d A = Q.topLeftCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(A);
  Eigen::Index least = 0;
  eigen.eigenvalues().cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d x = eigen.eigenvectors().col((least + 1) % 3);
  const Eigen::Vector3d y = eigen.eigenvectors().col((least + 2) % 3);
  PrincipalFrame f;
  f.R << x, y, x.cross(y);
  f.b = f.R.transpose() * Q.topRightCorner<3, 1>();
  f.l1 = eigen.eigenvalues()[(least + 1) % 3];
  f.l2 = eigen.eigenvalues()[(least + 2) % 3];
  f.j = Q(3, 3);
  return f;
}

/// Circle of points projected along the axis: centre (on the plane through the origin) and radius.
std::optional<std::pair<Eigen::Vector3d, double>> circle_across(const FitPoints& p,
                                                                const Eigen::Vector3d& axis) {
  const Eigen::Matrix3d R = pose_along(Eigen::Vector3d::Zero(), axis).linear();
  const Eigen::Vector3f e1 = R.col(0).cast<float>(), e2 = R.col(1).cast<float>();
  Eigen::Matrix<float, Eigen::Dynamic, 4> M(p.size(), 4);
  M.col(0) = (e1.x() * p.x + e1.y() * p.y + e1.z() * p.z).matrix();
  M.col(1) = (e2.x() * p.x + e2.y() * p.y + e2.z() * p.z).matrix();
  M.col(2).setOnes();
  M.col(3) = (M.col(0).array().square() + M.col(1).array().square()).matrix();
  const Eigen::Matrix4d S = (M.transpose() * M).cast<double>();
  const Eigen::Matrix3d A = S.topLeftCorner<3, 3>();
  const Eigen::Vector3d b = S.topRightCorner<3, 1>();
  const Eigen::Vector3d s = A.ldlt().solve(b);
  const double r2 = s[2] + 0.25 * (s[0] * s[0] + s[1] * s[1]);
  if (!(r2 > 0) || !s.allFinite()) return std::nullopt;
  return std::pair(Eigen::Vector3d(0.5 * (s[0] * R.col(0) + s[1] * R.col(1))), std::sqrt(r2));
}

}  // namespace

std::optional<PosedQuadric> initial_plane(const FitPoints& p) {
  const Eigen::Vector3d mean = mean_x(p);
  const Eigen::Matrix3d S = sum_of_xx(p) - static_cast<double>(p.size()) * mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(S);
  if (!(eigen.eigenvalues()[1] > 0)) return std::nullopt;
  PosedQuadric plane;
  plane.X = pose_along(mean, eigen.eigenvectors().col(0));
  plane.D(2, 3) = plane.D(3, 2) = 0.5;
  return plane;
}

std::optional<PosedQuadric> initial_sphere(const FitPoints& p) {
  Eigen::Matrix<float, Eigen::Dynamic, 5> M(p.size(), 5);
  M << p.x.matrix(), p.y.matrix(), p.z.matrix(), Eigen::VectorXf::Ones(p.size()),
      (p.x.square() + p.y.square() + p.z.square()).matrix();
  const Eigen::Matrix<double, 5, 5> S = (M.transpose() * M).cast<double>();
  const Eigen::Matrix4d A = S.topLeftCorner<4, 4>();
  const Eigen::Vector4d b = S.topRightCorner<4, 1>();
  const Eigen::Vector4d s = A.ldlt().solve(b);
  const Eigen::Vector3d centre = 0.5 * s.head<3>();
  const double r2 = s[3] + centre.squaredNorm();
  if (!s.allFinite() || !(r2 > 0)) return std::nullopt;
  PosedQuadric sphere;
  sphere.X.translation() = centre;
  sphere.D = diagonal(1, 1, 1, -r2);
  return sphere;
}

std::optional<PosedQuadric> initial_cylinder(const FitPoints& p) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sum_of_nn(p));
  const Eigen::Vector3d axis = eigen.eigenvectors().col(0);
  const auto circle = circle_across(p, axis);
  if (!circle) return std::nullopt;
  PosedQuadric cylinder;
  cylinder.X = pose_along(circle->first, axis);
  cylinder.D = diagonal(1, 1, 0, -circle->second * circle->second);
  return cylinder;
}

std::optional<PosedQuadric> initial_cone(const FitPoints& p) {
  const Eigen::Vector3d n = mean_n(p);
  const Eigen::Matrix3d S = sum_of_nn(p) - static_cast<double>(p.size()) * n * n.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(S);
  const Eigen::Vector3d axis = eigen.eigenvectors().col(0);
  // The apex lies in each tangent plane: nᵢ·apex = nᵢ·xᵢ.
  const Eigen::ArrayXf d = p.nx * p.x + p.ny * p.y + p.nz * p.z;
  const Eigen::Vector3d b =
      Eigen::Vector3f((p.nx * d).sum(), (p.ny * d).sum(), (p.nz * d).sum()).cast<double>();
  const Eigen::Matrix3d N = sum_of_nn(p);
  const Eigen::Vector3d apex = N.ldlt().solve(b);
  // Each unit normal has the same component along the axis, so their mean has it too.
  const double sine = std::abs(n.dot(axis));
  if (!apex.allFinite() || apex.norm() > 1e3 || sine < 1e-3 || sine > 0.999) return std::nullopt;
  const double k2 = sine * sine / (1 - sine * sine);
  PosedQuadric cone;
  cone.X = pose_along(apex, axis);
  cone.D = diagonal(1, 1, -k2, 0);
  return cone;
}

std::optional<PosedQuadric> initial_revolution(const FitPoints& p) {
  // A normal line (n, x × n) meets the axis (a, m) where n·m + (x × n)·a = 0.
  Eigen::Matrix<float, Eigen::Dynamic, 6> H(p.size(), 6);
  H << (p.y * p.nz - p.z * p.ny).matrix(), (p.z * p.nx - p.x * p.nz).matrix(),
      (p.x * p.ny - p.y * p.nx).matrix(), p.nx.matrix(), p.ny.matrix(), p.nz.matrix();
  const Matrix6d S = (H.transpose() * H).cast<double>();
  // Least |H [a m]| with |a| = 1: eliminate m.
  const Eigen::Matrix3d Smm =
      S.bottomRightCorner<3, 3>() +
      1e-9 * S.bottomRightCorner<3, 3>().trace() * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d K = -Smm.ldlt().solve(Eigen::Matrix3d(S.bottomLeftCorner<3, 3>()));
  const Eigen::Matrix3d reduced = S.topLeftCorner<3, 3>() + S.topRightCorner<3, 3>() * K;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(0.5 * (reduced + reduced.transpose())));
  const Eigen::Vector3d a = eigen.eigenvectors().col(0);
  const Eigen::Vector3d foot = a.cross(Eigen::Vector3d(K * a));
  if (!foot.allFinite() || foot.norm() > 100) return std::nullopt;
  // Profile ρ² = α + β s + γ s².
  const Eigen::Isometry3d X = pose_along(foot, a);
  const Eigen::Isometry3f Y = X.inverse().cast<float>();
  const auto local = [&](int r) { return Y(r, 0) * p.x + Y(r, 1) * p.y + Y(r, 2) * p.z + Y(r, 3); };
  const Eigen::ArrayXf s = local(2);
  Eigen::Matrix<float, Eigen::Dynamic, 4> M(p.size(), 4);
  M << Eigen::VectorXf::Ones(p.size()), s.matrix(), s.square().matrix(),
      (local(0).square() + local(1).square()).matrix();
  const Eigen::Matrix4d P = (M.transpose() * M).cast<double>();
  const Eigen::Matrix3d A = P.topLeftCorner<3, 3>();
  const Eigen::Vector3d rhs = P.topRightCorner<3, 1>();
  const Eigen::Vector3d profile = A.ldlt().solve(rhs);
  if (!profile.allFinite()) return std::nullopt;
  PosedQuadric revolution;
  revolution.X = X;
  revolution.D = diagonal(1, 1, -profile[2], -profile[0]);
  revolution.D(2, 3) = revolution.D(3, 2) = -0.5 * profile[1];
  return revolution;
}

std::optional<PosedQuadric> initial_paraboloid(const PosedQuadric& revolution) {
  PosedQuadric paraboloid = revolution;
  const double i = revolution.D(2, 3), j = revolution.D(3, 3);
  if (std::abs(i) < 1e-6) return std::nullopt;
  // x² + y² + 2 i z + j = 0 has its vertex at z = -j / 2i.
  paraboloid.D(2, 2) = paraboloid.D(3, 3) = 0.0;
  paraboloid.X = revolution.X * Eigen::Translation3d(0, 0, -0.5 * j / i);
  if (std::abs(0.5 * j / i) > 1e3) return std::nullopt;
  return paraboloid;
}

std::optional<PosedQuadric> tangent_cone(const PosedQuadric& revolution) {
  // About z = 0, ρ² = −j − 2 i z − c z²: radius r, slope dρ/dz = −i / r.
  const double i = revolution.D(2, 3), j = revolution.D(3, 3);
  if (!(j < 0) || std::abs(i) < 1e-9) return std::nullopt;
  const double r = std::sqrt(-j), slope = -i / r;
  if (std::abs(r / slope) > 1e3) return std::nullopt;
  PosedQuadric cone;
  cone.X = revolution.X * Eigen::Translation3d(0, 0, -r / slope);
  cone.D = diagonal(1, 1, -slope * slope, 0);
  return cone;
}

std::optional<PosedQuadric> tangent_cylinder(const PosedQuadric& revolution) {
  const double j = revolution.D(3, 3);
  if (!(j < 0)) return std::nullopt;
  PosedQuadric cylinder = revolution;
  cylinder.D = diagonal(1, 1, 0, j);
  return cylinder;
}

std::optional<PosedQuadric> nearest_parabolic(const PosedQuadric& general) {
  const PrincipalFrame f = principal_frame(general);
  // λ₁x² + λ₂y² + 2 b·x + j = 0 has its vertex where the first two derivatives and f vanish.
  Eigen::Vector3d vertex(-f.b.x() / f.l1, -f.b.y() / f.l2, 0.0);
  vertex.z() = -0.5 * (f.j + f.b.x() * vertex.x() + f.b.y() * vertex.y()) / f.b.z();
  if (!vertex.allFinite() || vertex.norm() > 1e3) return std::nullopt;
  PosedQuadric parabolic;
  parabolic.X.linear() = f.R;
  parabolic.X.translation() = f.R * vertex;
  parabolic.D = diagonal(f.l1 / f.b.z(), f.l2 / f.b.z(), 0, 0);
  parabolic.D(2, 3) = parabolic.D(3, 2) = 1.0;
  return parabolic;
}

std::optional<PosedQuadric> nearest_cylindrical(const PosedQuadric& general) {
  const PrincipalFrame f = principal_frame(general);
  const Eigen::Vector3d centre(-f.b.x() / f.l1, -f.b.y() / f.l2, 0.0);
  const double k = f.j + f.b.x() * centre.x() + f.b.y() * centre.y();
  if (!centre.allFinite() || centre.norm() > 1e3 || k == 0.0) return std::nullopt;
  PosedQuadric cylinder;
  cylinder.X.linear() = f.R;
  cylinder.X.translation() = f.R * centre;
  cylinder.D = diagonal(-f.l1 / k, -f.l2 / k, 0, -1);
  return cylinder;
}

std::optional<PosedQuadric> initial_general(const FitPoints& p) {
  const Eigen::Index n = p.size();
  if (n < 9) return std::nullopt;
  Eigen::Matrix<float, Eigen::Dynamic, 10> V(n, 10);
  V << p.x.square().matrix(), p.y.square().matrix(), p.z.square().matrix(),
      (2.0f * p.x * p.y).matrix(), (2.0f * p.x * p.z).matrix(), (2.0f * p.y * p.z).matrix(),
      (2.0f * p.x).matrix(), (2.0f * p.y).matrix(), (2.0f * p.z).matrix(), Eigen::VectorXf::Ones(n);
  const Matrix10d S = (V.transpose() * V).cast<double>();
  // Scatter of the gradient: ∇v of x² is (2x, 0, 0), of 2xy is (2y, 2x, 0), of 2x is (2, 0, 0).
  const double xx = S(0, 9), yy = S(1, 9), zz = S(2, 9);
  const double xy = 0.5 * S(3, 9), xz = 0.5 * S(4, 9), yz = 0.5 * S(5, 9);
  const double x = 0.5 * S(6, 9), y = 0.5 * S(7, 9), z = 0.5 * S(8, 9);
  const double count = static_cast<double>(n);
  Matrix10d G = Matrix10d::Zero();
  // clang-format off
  G.row(0).head<9>() << xx, 0, 0, xy, xz, 0, x, 0, 0;
  G.row(1).head<9>() << 0, yy, 0, xy, 0, yz, 0, y, 0;
  G.row(2).head<9>() << 0, 0, zz, 0, xz, yz, 0, 0, z;
  G.row(3).head<9>() << xy, xy, 0, xx + yy, yz, xz, y, x, 0;
  G.row(4).head<9>() << xz, 0, xz, yz, xx + zz, xy, z, 0, x;
  G.row(5).head<9>() << 0, yz, yz, xz, xy, yy + zz, 0, z, y;
  G.row(6).head<9>() << x, 0, 0, y, z, 0, count, 0, 0;
  G.row(7).head<9>() << 0, y, 0, x, 0, z, 0, count, 0;
  G.row(8).head<9>() << 0, 0, z, 0, x, y, 0, 0, count;
  // clang-format on
  G *= 4.0;
  // G is singular in the constant alone, which the scatter eliminates.
  const Eigen::Matrix<double, 9, 9> reduced =
      S.topLeftCorner<9, 9>() - S.topRightCorner<9, 1>() * S.bottomLeftCorner<1, 9>() / S(9, 9);
  Eigen::Matrix<double, 9, 9> weight = G.topLeftCorner<9, 9>();
  weight.diagonal().array() += 1e-9 * weight.trace();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> eigen(reduced,
                                                                                    weight);
  if (eigen.info() != Eigen::Success) return std::nullopt;
  Eigen::Matrix<double, 10, 1> q;
  q.head<9>() = eigen.eigenvectors().col(0);
  q[9] = -S.bottomLeftCorner<1, 9>().dot(q.head<9>()) / S(9, 9);
  if (!q.allFinite()) return std::nullopt;
  PosedQuadric general;
  general.D << q[0], q[3], q[4], q[6],  //
      q[3], q[1], q[5], q[7],           //
      q[4], q[5], q[2], q[8],           //
      q[6], q[7], q[8], q[9];
  general.D /= general.D.norm();
  return general;
}

}  // namespace quadrille

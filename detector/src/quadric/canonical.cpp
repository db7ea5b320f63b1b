#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/symmetric_eigen.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

/// The form λ₁x² + λ₂y² + λ₃z² + 2 b·x + j in the frame of the eigenvectors; zero eigenvalues are
/// exact.
struct Diagonal {
  Eigen::Matrix3d R;
  Eigen::Vector3d lambda, b;
  double j;
  int rank;
};

Diagonal diagonalise(const Quadric& Q, double tolerance) {
  const Eigen::Matrix4d M = Q.matrix() / Q.matrix().cwiseAbs().maxCoeff();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(M.topLeftCorner<3, 3>()));
  // Sorts the eigenvalues by magnitude, the largest first.
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int c) {
    return std::abs(eigen.eigenvalues()[a]) > std::abs(eigen.eigenvalues()[c]);
  });
  Diagonal d;
  for (int k = 0; k < 3; ++k) {
    d.R.col(k) = eigen.eigenvectors().col(order[k]);
    d.lambda[k] = eigen.eigenvalues()[order[k]];
  }
  const double least = tolerance * std::max(1e-300, std::abs(d.lambda[0]));
  d.rank = 0;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(d.lambda[k]) > least && std::abs(d.lambda[0]) > 1e-12) {
      ++d.rank;
    } else {
      d.lambda[k] = 0.0;
    }
  }
  d.b = d.R.transpose() * M.topRightCorner<3, 1>();
  d.j = M(3, 3);
  return d;
}

/// Pose with the given x and z axes; y completes a right-handed frame.
Eigen::Isometry3d frame(const Eigen::Vector3d& origin, const Eigen::Vector3d& x,
                        const Eigen::Vector3d& z) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear().col(0) = x;
  X.linear().col(1) = z.cross(x);
  X.linear().col(2) = z;
  X.translation() = origin;
  return X;
}

bool equal(double a, double b, double tolerance) {
  // A relative difference of eigenvalues gives half that difference of semi-axes; the factor leaves
  // slack for rounding.
  return std::abs(a - b) <= 10.0 * tolerance * std::max(std::abs(a), std::abs(b));
}

/// Rank 3 with three eigenvalues of one sign: λ·x² + k = 0, where k has the opposite sign.
CanonicalForm ellipsoid(const Diagonal& d, const Eigen::Vector3d& centre, double k, double tol) {
  std::array<std::pair<double, int>, 3> axes;
  for (int i = 0; i < 3; ++i) axes[i] = {std::sqrt(-k / d.lambda[i]), i};
  std::sort(axes.rbegin(), axes.rend());
  CanonicalForm form;
  if (equal(axes[0].first, axes[2].first, tol)) {
    form.type = QuadricType::kSphere;
    form.X.translation() = centre;
    form.dimensions = {{"radius", axes[1].first}};
    return form;
  }
  // A spheroid's axis of revolution becomes z.
  if (equal(axes[1].first, axes[2].first, tol))
    std::rotate(axes.begin(), axes.begin() + 1, axes.end());
  form.type = QuadricType::kEllipsoid;
  form.X = frame(centre, d.R.col(axes[0].second), d.R.col(axes[2].second));
  form.dimensions = {{"a", axes[0].first}, {"b", axes[1].first}, {"c", axes[2].first}};
  return form;
}

/// Rank 3 with two signs: cones and hyperboloids. The z axis is the eigenvector whose sign occurs
/// once.
CanonicalForm hyperboloid(const Diagonal& d, const Eigen::Vector3d& centre, double k, double tol) {
  int odd = 0;
  for (int i = 0; i < 3; ++i) {
    const int other = (i + 1) % 3, third = (i + 2) % 3;
    if (d.lambda[other] * d.lambda[third] > 0) odd = i;
  }
  int first = (odd + 1) % 3, second = (odd + 2) % 3;
  if (std::abs(d.lambda[first]) > std::abs(d.lambda[second])) std::swap(first, second);
  CanonicalForm form;
  form.X = frame(centre, d.R.col(first), d.R.col(odd));
  const double la = std::abs(d.lambda[first]), lb = std::abs(d.lambda[second]);
  const double lc = std::abs(d.lambda[odd]);
  if (k == 0.0) {
    const double half_a = std::atan(std::sqrt(lc / la)), half_b = std::atan(std::sqrt(lc / lb));
    if (equal(la, lb, tol)) {
      form.type = QuadricType::kCone;
      form.dimensions = {{"half_angle", half_a}};
    } else {
      form.type = QuadricType::kEllipticCone;
      form.dimensions = {{"half_angle_a", half_a}, {"half_angle_b", half_b}};
    }
    return form;
  }
  // With one sheet, the constant's sign is opposite to the two equal signs; with two sheets, to the
  // single one.
  form.type = k * d.lambda[first] < 0 ? QuadricType::kHyperboloidOneSheet
                                      : QuadricType::kHyperboloidTwoSheets;
  const double size = std::abs(k);
  form.dimensions = {
      {"a", std::sqrt(size / la)}, {"b", std::sqrt(size / lb)}, {"c", std::sqrt(size / lc)}};
  return form;
}

CanonicalForm paraboloid(const Diagonal& d, const Eigen::Vector3d& local) {
  // About the vertex λ₁x² + λ₂y² + 2 b z = 0, thus z = −(λ₁x² + λ₂y²) / 2b.
  double fa = -0.5 * d.b[2] / d.lambda[0], fb = -0.5 * d.b[2] / d.lambda[1];
  Eigen::Vector3d z = d.R.col(2), x = d.R.col(0);
  if (fa + fb < 0 || (fa + fb == 0 && fa < 0)) fa = -fa, fb = -fb, z = -z;
  CanonicalForm form;
  const bool elliptic = fa * fb > 0;
  form.type = elliptic ? QuadricType::kEllipticParaboloid : QuadricType::kHyperbolicParaboloid;
  if (elliptic ? fa < fb : fa < 0) std::swap(fa, fb), x = d.R.col(1);
  form.X = frame(d.R * local, x, z);
  form.dimensions = {{"focal_a", fa}, {"focal_b", std::abs(fb)}};
  return form;
}

/// Rank 2 without a linear part along the null direction: cylinders and pairs of planes.
CanonicalForm cylinder(const Diagonal& d, const Eigen::Vector3d& centre, double k, double tol) {
  CanonicalForm form;
  const Eigen::Vector3d z = d.R.col(2);
  const double l0 = d.lambda[0], l1 = d.lambda[1];
  const bool same = l0 * l1 > 0;
  if (k == 0.0) {
    form.type = same ? QuadricType::kImaginaryIntersectingPlanes : QuadricType::kIntersectingPlanes;
    form.X = frame(centre, d.R.col(1), z);
    // y² = t² x² with t ≤ 1: x bisects the smaller angle, 2 atan t.
    if (!same) form.dimensions = {{"angle", 2.0 * std::atan(std::sqrt(std::abs(l1 / l0)))}};
    return form;
  }
  if (same && k * l0 > 0) {
    form.type = QuadricType::kImaginaryEllipticCylinder;
    form.X = frame(centre, d.R.col(0), z);
    return form;
  }
  const double r0 = std::sqrt(std::abs(k / l0)), r1 = std::sqrt(std::abs(k / l1));
  if (!same) {
    form.type = QuadricType::kHyperbolicCylinder;
    const int real = k * l0 < 0 ? 0 : 1;
    form.X = frame(centre, d.R.col(real), z);
    form.dimensions = {{"a", real ? r1 : r0}, {"b", real ? r0 : r1}};
  } else if (equal(r0, r1, tol)) {
    form.type = QuadricType::kCylinder;
    form.X = frame(centre, d.R.col(0), z);
    form.dimensions = {{"radius", 0.5 * (r0 + r1)}};
  } else {
    form.type = QuadricType::kEllipticCylinder;
    form.X = frame(centre, d.R.col(r0 > r1 ? 0 : 1), z);
    form.dimensions = {{"a", std::max(r0, r1)}, {"b", std::min(r0, r1)}};
  }
  return form;
}

CanonicalForm from_rank_3(const Diagonal& d, double tol) {
  const Eigen::Vector3d local = -d.b.cwiseQuotient(d.lambda);
  const double k = d.j + d.b.dot(local);
  const double size = std::abs(d.j) + std::abs(d.b.dot(local)) + std::abs(d.lambda[0]) * 1e-12;
  const double constant = std::abs(k) <= tol * std::max(size, std::abs(d.lambda[0])) ? 0.0 : k;
  const Eigen::Vector3d centre = d.R * local;
  const bool definite = d.lambda[0] * d.lambda[1] > 0 && d.lambda[1] * d.lambda[2] > 0;
  if (!definite) return hyperboloid(d, centre, constant, tol);
  if (constant != 0.0 && constant * d.lambda[0] < 0) return ellipsoid(d, centre, constant, tol);
  CanonicalForm form;
  form.type = constant == 0.0 ? QuadricType::kImaginaryCone : QuadricType::kImaginaryEllipsoid;
  form.X.translation() = centre;
  return form;
}

CanonicalForm from_rank_2(const Diagonal& d, double tol) {
  Eigen::Vector3d local(-d.b[0] / d.lambda[0], -d.b[1] / d.lambda[1], 0.0);
  const double k = d.j + d.b[0] * local[0] + d.b[1] * local[1];
  if (std::abs(d.b[2]) > tol) {
    local[2] = -0.5 * k / d.b[2];
    return paraboloid(d, local);
  }
  const double size = std::max({std::abs(d.j), std::abs(d.b[0] * local[0]), std::abs(d.lambda[0])});
  return cylinder(d, d.R * local, std::abs(k) <= tol * size ? 0.0 : k, tol);
}

CanonicalForm from_rank_1(const Diagonal& d, double tol) {
  CanonicalForm form;
  const Eigen::Vector2d across(d.b[1], d.b[2]);
  Eigen::Vector3d local(-d.b[0] / d.lambda[0], 0, 0);
  const double k = d.j + d.b[0] * local[0];
  if (across.norm() > tol) {
    // The form is λx² + 2 β s + k = 0, where s runs in the direction of the linear part.
    const Eigen::Vector3d s = (across[0] * d.R.col(1) + across[1] * d.R.col(2)).normalized();
    const double beta = across.norm(), focal = -0.5 * beta / d.lambda[0];
    form.type = QuadricType::kParabolicCylinder;
    const Eigen::Vector3d vertex = d.R * local - 0.5 * k / beta * s;
    form.X = frame(vertex, d.R.col(0), focal > 0 ? s : Eigen::Vector3d(-s));
    form.dimensions = {{"focal", std::abs(focal)}};
    return form;
  }
  form.X = frame(d.R * local, d.R.col(1), d.R.col(0));
  const double size = std::max({std::abs(d.j), std::abs(d.b[0] * local[0]), std::abs(d.lambda[0])});
  if (std::abs(k) <= tol * size) {
    form.type = QuadricType::kCoincidentPlanes;
  } else if (k * d.lambda[0] > 0) {
    form.type = QuadricType::kImaginaryParallelPlanes;
  } else {
    form.type = QuadricType::kParallelPlanes;
    form.dimensions = {{"distance", 2.0 * std::sqrt(-k / d.lambda[0])}};
  }
  return form;
}

CanonicalForm from_rank_0(const Diagonal& d) {
  const Eigen::Vector3d n = d.R * d.b;
  if (!(n.norm() > 1e-12)) throw std::invalid_argument("canonical_form: Q is a constant");
  CanonicalForm form;
  form.type = QuadricType::kPlane;
  const Eigen::Vector3d z = n.normalized();
  form.X = frame(-0.5 * d.j / n.norm() * z, z.unitOrthogonal(), z);
  return form;
}

}  // namespace

bool is_angle(const std::string& dimension) {
  return dimension == "angle" || dimension.starts_with("half_angle");
}

CanonicalForm canonical_form(const Quadric& Q, double tolerance) {
  if (!Q.matrix().allFinite() || Q.matrix().isZero(0.0)) {
    throw std::invalid_argument("canonical_form: Q is zero or not finite");
  }
  const Diagonal d = diagonalise(Q, tolerance);
  switch (d.rank) {
    case 3:
      return from_rank_3(d, tolerance);
    case 2:
      return from_rank_2(d, tolerance);
    case 1:
      return from_rank_1(d, tolerance);
    default:
      return from_rank_0(d);
  }
}

}  // namespace quadrille

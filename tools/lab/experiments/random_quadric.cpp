#include "lab/experiments/random_quadric.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace quadrille::experiments {
namespace {

using Names = std::vector<std::string>;

Names dimensions_of(QuadricType type) {
  using T = QuadricType;
  switch (type) {
    case T::kSphere:
    case T::kCylinder:
      return {"radius"};
    case T::kCone:
      return {"half_angle"};
    case T::kEllipticCone:
      return {"half_angle_a", "half_angle_b"};
    case T::kEllipticParaboloid:
    case T::kHyperbolicParaboloid:
      return {"focal_a", "focal_b"};
    case T::kEllipticCylinder:
    case T::kHyperbolicCylinder:
      return {"a", "b"};
    case T::kParabolicCylinder:
      return {"focal"};
    default:
      return {"a", "b", "c"};
  }
}

/// Returns a size with which the surface fills the unit ball well.
double random_dimension(QuadricType type, const std::string& name, RandomStream& random) {
  const double u = random.uniform();
  const bool apart =
      type == QuadricType::kHyperboloidTwoSheets || type == QuadricType::kHyperbolicCylinder;
  if (apart) return 0.2 + 0.25 * u;
  if (name.starts_with("half_angle")) return 0.3 + 0.5 * u;
  if (name.starts_with("focal")) return 0.15 + 0.35 * u;
  return 0.35 + 0.55 * u;
}

Eigen::Matrix3d random_rotation(RandomStream& random) {
  Eigen::Vector4d q;
  for (int i = 0; i < 4; ++i) q[i] = gaussian(random);
  return Eigen::Quaterniond(q).normalized().toRotationMatrix();
}

/// Returns the parameters t at which the line x + t d meets the quadric.
std::vector<double> meet(const Quadric& Q, const Eigen::Vector3d& x, const Eigen::Vector3d& d) {
  const double a = d.dot(Q.matrix().topLeftCorner<3, 3>() * d);
  const double b = 0.5 * d.dot(Q.gradient(x)), c = Q.value(x);
  if (std::abs(a) < 1e-12)
    return b == 0.0 ? std::vector<double>() : std::vector<double>{-c / b / 2};
  const double root = b * b - a * c;
  if (root < 0.0) return {};
  // The root of larger magnitude is computed first, which avoids cancellation.
  const double far = -(b + std::copysign(std::sqrt(root), b));
  if (far == 0.0) return {0.0};
  return {far / a, c / far};
}

}  // namespace

QuadricType curved_type(int index) {
  using T = QuadricType;
  constexpr std::array<T, kCurvedTypes> types = {T::kSphere,
                                                 T::kEllipsoid,
                                                 T::kCylinder,
                                                 T::kCone,
                                                 T::kHyperboloidOneSheet,
                                                 T::kEllipticParaboloid,
                                                 T::kEllipticCylinder,
                                                 T::kHyperbolicParaboloid,
                                                 T::kHyperboloidTwoSheets,
                                                 T::kEllipticCone,
                                                 T::kParabolicCylinder,
                                                 T::kHyperbolicCylinder};
  return types.at(static_cast<std::size_t>(index));
}

double gaussian(RandomStream& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * M_PI * random.uniform());
}

Eigen::Vector3d random_direction(RandomStream& random) {
  Eigen::Vector3d d;
  for (int i = 0; i < 3; ++i) d[i] = gaussian(random);
  return d.normalized();
}

Quadric random_quadric(QuadricType type, RandomStream& random) {
  CanonicalForm form{type, Eigen::Isometry3d::Identity(), {}};
  for (const std::string& name : dimensions_of(type)) {
    form.dimensions.emplace_back(name, random_dimension(type, name, random));
  }
  form.X.linear() = random_rotation(random);
  return from_canonical(form).normalized();
}

OrientedPointsd sample(const Quadric& Q, Eigen::Index count, RandomStream& random) {
  OrientedPointsd result(count);
  Eigen::Index found = 0;
  for (Eigen::Index trial = 0; found < count; ++trial) {
    if (trial > 1000 * (count + 10)) throw std::invalid_argument("no line meets the quadric");
    const Eigen::Vector3d d = random_direction(random);
    const Eigen::Vector3d side = d.unitOrthogonal(), other = d.cross(side);
    const double radius = std::sqrt(random.uniform()), angle = 2.0 * M_PI * random.uniform();
    const Eigen::Vector3d x = radius * (std::cos(angle) * side + std::sin(angle) * other);
    for (const double t : meet(Q, x, d)) {
      const Eigen::Vector3d y = x + t * d, g = Q.gradient(y);
      // An apex has no normal.
      if (found == count || y.norm() > 1.0 || g.norm() < 1e-3) continue;
      result.points.col(found) = y;
      result.normals.col(found++) = g.normalized();
    }
  }
  return result;
}

void add_point_noise(OrientedPointsd* points, double deviation, RandomStream& random) {
  for (double& coordinate : points->points.reshaped()) coordinate += deviation * gaussian(random);
}

void add_normal_noise(OrientedPointsd* points, double deviation, RandomStream& random) {
  for (Eigen::Index i = 0; i < points->size(); ++i) {
    auto n = points->normals.col(i);
    const Eigen::Vector3d side = n.unitOrthogonal(), other = n.cross(side);
    n += deviation * (gaussian(random) * side + gaussian(random) * other);
    n.normalize();
  }
}

void estimate_normals(OrientedPointsd* points, int neighbours) {
  const Eigen::Index count = std::min<Eigen::Index>(neighbours, points->size());
  const Eigen::Matrix3Xd before = points->normals;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points->size()));
  for (Eigen::Index i = 0; i < points->size(); ++i) {
    const Eigen::VectorXd distance =
        (points->points.colwise() - points->points.col(i)).colwise().squaredNorm();
    std::iota(order.begin(), order.end(), 0);
    std::nth_element(order.begin(), order.begin() + (count - 1), order.end(),
                     [&](Eigen::Index a, Eigen::Index b) { return distance[a] < distance[b]; });
    Eigen::Matrix3Xd near(3, count);
    for (Eigen::Index k = 0; k < count; ++k) near.col(k) = points->points.col(order[k]);
    near.colwise() -= Eigen::Vector3d(near.rowwise().mean());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(near * near.transpose());
    const Eigen::Vector3d n = solver.eigenvectors().col(0);
    points->normals.col(i) = n.dot(before.col(i)) < 0.0 ? Eigen::Vector3d(-n) : n;
  }
}

double size_of(const Eigen::Matrix3Xd& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
}

}  // namespace quadrille::experiments

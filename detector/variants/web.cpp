#include "variants/web.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "fit/monomials.hpp"

namespace quadrille {
namespace {

// If a noisy basis needs one of its normals scaled down below this factor, it is not voted on.
constexpr double kMinScale = 0.25;
// Least length of a unit normal's projection to the plane of basis and voter; a shorter one does
// not determine the scale.
constexpr double kMinProjection = 0.1;
// Least squared distance of the two points of a basis, in their squared unit.
constexpr double kMinSquare = 1e-12;

}  // namespace

Eigen::Matrix4d Web::at(const Eigen::Vector3d& lambda) const {
  return Q0 + lambda[0] * p * p.transpose() + lambda[1] * symmetric_product(p, q) +
         lambda[2] * q * q.transpose();
}

std::optional<Web> make_web(const std::array<OrientedPoint, 2>& basis, double softness) {
  const Eigen::Vector3d e = basis[1].x - basis[0].x;
  const double square = e.squaredNorm();
  if (!(square > kMinSquare)) return std::nullopt;
  // Least squares of α₁b₁ − α₂b₂ = 0 with the prior α = 1.
  const double b1 = basis[0].n.dot(e), b2 = -basis[1].n.dot(e);
  const double size = softness * softness * square + b1 * b1 + b2 * b2;
  const double excess = size > 0.0 ? (b1 - b2) / size : 0.0;
  const std::array<double, 2> alpha = {1.0 - b1 * excess, 1.0 + b2 * excess};
  const double least = softness > 0.0 ? kMinScale : 0.0;
  if (!(alpha[0] > least && alpha[1] > least)) return std::nullopt;

  const auto affine = [&](const Eigen::Vector3d& g, double at) {
    return Eigen::Vector4d(g.x(), g.y(), g.z(), at - g.dot(basis[0].x));
  };
  const Eigen::Vector3d p = e.unitOrthogonal(), q = e.normalized().cross(p);
  const std::array<Eigen::Vector4d, 2> u = {affine(-e / square, 1), affine(e / square, 0)};
  Web web;
  web.p = affine(p, 0), web.q = affine(q, 0);
  web.Q0 = 0.5 * (alpha[0] * b1 + alpha[1] * b2) * symmetric_product(u[0], u[1]);
  for (std::size_t i = 0; i < 2; ++i) {
    web.Q0 +=
        alpha[i] * symmetric_product(basis[i].n.dot(p) * web.p + basis[i].n.dot(q) * web.q, u[i]);
  }
  return web;
}

std::optional<WebLine> line_of(const Web& web, const OrientedPoint& point, double min_height,
                               double min_cosine) {
  const Eigen::Vector4d x = point.x.homogeneous();
  const double pv = web.p.dot(x), qv = web.q.dot(x), height = std::hypot(pv, qv);
  if (!(height > min_height)) return std::nullopt;
  const double c = pv / height, s = qv / height;
  const Eigen::Vector3d p = c * web.p.head<3>() + s * web.q.head<3>();
  const Eigen::Vector3d q = c * web.q.head<3>() - s * web.p.head<3>();
  const Eigen::Vector3d along = p.cross(q);
  const Eigen::Vector4d h = web.Q0 * x;
  const Eigen::Vector3d g = 2.0 * h.head<3>();
  const double first = -x.dot(h) / (height * height);
  const Eigen::Vector2d gradient(g.dot(along), g.dot(p) + 2.0 * first * height);
  const Eigen::Vector2d normal(point.n.dot(along), point.n.dot(p));
  const double within = normal.norm(), product = gradient.dot(normal);
  if (!(within > kMinProjection && product >= min_cosine * within * gradient.norm())) {
    return std::nullopt;
  }
  const double scale = product / (within * within);
  const double second = (scale * point.n.dot(q) - g.dot(q)) / height;
  return WebLine{first * Eigen::Vector3d(c * c, 2 * c * s, s * s) +
                     second * Eigen::Vector3d(-c * s, c * c - s * s, c * s),
                 Eigen::Vector3d(s * s, -2 * c * s, c * c)};
}

}  // namespace quadrille

#include "lab/scene/surface.hpp"

#include <cmath>

namespace quadrille::scene {

SurfaceCaster::SurfaceCaster(const Surface& surface, const Eigen::Isometry3d& X_CS)
    : surface_(surface), X_SC_(X_CS.inverse()), Q_C_(surface.Q_S.transformed(X_CS).normalized()) {}

bool SurfaceCaster::holds(const Eigen::Vector3d& p_C) const {
  constexpr double kSlack = 1e-9;
  const Eigen::Vector3d p_S = X_SC_ * p_C;
  return ((p_S - surface_.box_S.min()).array() >= -kSlack).all() &&
         ((surface_.box_S.max() - p_S).array() >= -kSlack).all() &&
         (!surface_.within_S || surface_.within_S->value(p_S) <= 0.0);
}

std::optional<double> SurfaceCaster::first_hit(const Eigen::Vector3d& ray) const {
  auto [near, far] = Q_C_.crossings(Eigen::Vector3d::Zero(), ray);
  if (far > 0.0 && far < near) std::swap(near, far);
  for (const double t : {near, far}) {
    if (t > 0.0 && std::isfinite(t) && holds(t * ray)) return t;
  }
  return std::nullopt;
}

Eigen::Vector3d SurfaceCaster::normal(const Eigen::Vector3d& p_C) const {
  const Eigen::Vector3d n = Q_C_.gradient(p_C).normalized();
  return n.dot(p_C) > 0.0 ? Eigen::Vector3d(-n) : n;
}

}  // namespace quadrille::scene

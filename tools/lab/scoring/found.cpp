#include "lab/scoring/found.hpp"

namespace quadrille::scoring {

double Found::value(const Eigen::Vector3d& p_C) const {
  return superquadric ? superquadric->value(p_C) : Q_C.value(p_C);
}

Eigen::Vector3d Found::gradient(const Eigen::Vector3d& p_C) const {
  return superquadric ? superquadric->gradient(p_C) : Q_C.gradient(p_C);
}

std::array<double, 2> Found::crossings(const Eigen::Vector3d& o, const Eigen::Vector3d& d) const {
  return superquadric ? superquadric->crossings(o, d) : Q_C.crossings(o, d);
}

bool Found::is_surface() const {
  if (superquadric) return superquadric->X_CS.matrix().allFinite();
  return Q_C.matrix().allFinite() && !Q_C.matrix().isZero(0.0);
}

}  // namespace quadrille::scoring

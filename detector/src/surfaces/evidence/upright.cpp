#include "surfaces/evidence/upright.hpp"

#include <cmath>

namespace quadrille {

bool has_axis(QuadricType type) {
  return type != QuadricType::kSphere && type != QuadricType::kEllipsoid;
}

double uprightness(const CanonicalForm& form, const std::optional<Eigen::Vector3d>& up) {
  return up && has_axis(form.type) ? std::abs(form.X.linear().col(2).dot(*up)) : 1.0;
}

}  // namespace quadrille

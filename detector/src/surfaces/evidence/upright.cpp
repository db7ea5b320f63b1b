#include "surfaces/evidence/upright.hpp"

#include <cmath>

namespace quadrille {

double uprightness(const CanonicalForm& form, const std::optional<Eigen::Vector3d>& up) {
  const bool has_axis = form.type != QuadricType::kSphere && form.type != QuadricType::kEllipsoid;
  return up && has_axis ? std::abs(form.X.linear().col(2).dot(*up)) : 1.0;
}

}  // namespace quadrille

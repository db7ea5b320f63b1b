#include "contacts/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quadrille {

double friction_needed(const ContactLine& line) {
  const Eigen::Vector3d along = (line.contacts_C[0] - line.contacts_C[1]).normalized();
  double worst = 0.0;
  for (int i = 0; i < 2; ++i) {
    const double c = (i == 0 ? 1.0 : -1.0) * line.normals_C[i].dot(along);
    if (c <= 0.0) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, line.normals_C[i].cross(along).norm() / c);
  }
  return worst;
}

double doubted_friction(const ContactLine& line) {
  return doubted_friction(friction_needed(line), line.lean_std);
}

double doubted_friction(double friction, double lean_std) {
  if (lean_std == 0.0) return friction;
  const double angle = std::atan(friction) + lean_std;
  return angle < 0.5 * std::numbers::pi ? std::tan(angle) : std::numeric_limits<double>::infinity();
}

double grasp_epsilon(const ContactLine& line, const ContactModel& model) {
  const double lean = std::atan(friction_needed(line));
  const double friction = std::tan(std::max(0.0, std::atan(model.friction) - lean));
  const double k = 0.5 * line.width / model.torque_scale;
  return std::min(model.torsion / model.torque_scale,
                  friction * k / std::sqrt(1.0 + k * k + friction * friction * k * k));
}

}  // namespace quadrille

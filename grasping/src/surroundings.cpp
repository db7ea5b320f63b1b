#include "quadrille/grasping/surroundings.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

void Surroundings::check() const {
  robot.check();
  if (!map.X_CM.matrix().allFinite() || !map.X_CM.linear().isUnitary(1e-3)) {
    throw std::invalid_argument("map needs a pose that is a finite, rigid motion");
  }
  if (!support) return;
  if (!(std::abs(support->n_C.norm() - 1.0) < 1e-6) || !std::isfinite(support->offset)) {
    throw std::invalid_argument("support needs a unit normal and a finite offset");
  }
}

std::vector<Eigen::Vector3d> viewpoints_of(const PointCloud& cloud, const Surroundings& known) {
  std::vector<Eigen::Vector3d> viewpoints_C = {cloud.viewpoint};
  for (const PointCloud& view : known.views) viewpoints_C.push_back(view.viewpoint);
  return viewpoints_C;
}

Surroundings moved(Surroundings surroundings, const Eigen::Isometry3d& X_FC) {
  for (PointCloud& view : surroundings.views) view = moved(std::move(view), X_FC);
  surroundings.robot = moved(std::move(surroundings.robot), X_FC);
  if (auto& support = surroundings.support) {
    support->n_C = X_FC.linear() * support->n_C;
    support->offset += support->n_C.dot(X_FC.translation());
  }
  surroundings.map.X_CM = X_FC * surroundings.map.X_CM;
  return surroundings;
}

}  // namespace quadrille

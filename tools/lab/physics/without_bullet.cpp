#include <stdexcept>

#include "lab/physics/trial.hpp"

namespace quadrille::physics {

std::string missing_physics() {
  return "this quadrille was built without Bullet; install libbullet-dev (tools/setup), then "
         "configure with -DQUADRILLE_WITH_BULLET=ON and build again";
}

TrialResult try_grasp(const TrueBody&, const Gripper&, const Grasp&, const Eigen::Isometry3d&,
                      const TrialOptions&) {
  throw std::runtime_error(missing_physics());
}

}  // namespace quadrille::physics

#include "hand/reachable_places.hpp"

namespace quadrille {

bool may_reach(const Reach& reach, const Eigen::Isometry3d& X_CP,
               const Eigen::AlignedBox3d& places) {
  const Eigen::Vector3d base = X_CP.inverse() * reach.base_C;
  const Eigen::Vector3d farthest =
      (places.max() - base).cwiseAbs().cwiseMax((places.min() - base).cwiseAbs());
  return places.exteriorDistance(base) <= reach.max && farthest.norm() >= reach.min;
}

bool may_approach(const Reach& reach, const Eigen::Isometry3d& X_CG,
                  const Eigen::AlignedBox3d& places_G, double approach) {
  const Eigen::Vector3d back(0.0, 0.0, -approach);
  return may_reach(reach, X_CG, places_G) &&
         may_reach(reach, X_CG, {places_G.min() + back, places_G.max() + back});
}

}  // namespace quadrille

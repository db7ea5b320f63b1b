#include "quadrille/grasping/rigid_motion.hpp"

#include <utility>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

Grasp moved(Grasp grasp, const Eigen::Isometry3d& X_FC) {
  grasp.X_CG = rounded(X_FC * grasp.X_CG);
  for (Eigen::Vector3d& contact : grasp.contacts_C) contact = X_FC * contact;
  return grasp;
}

CollisionShape moved(CollisionShape shape, const Eigen::Isometry3d& X_FC) {
  shape.X_CS = rounded(X_FC * shape.X_CS);
  return shape;
}

GraspPlan moved(GraspPlan plan, const Eigen::Isometry3d& X_FC) {
  plan.boxes = moved(std::move(plan.boxes), X_FC);
  for (Grasp& grasp : plan.grasps) grasp = moved(std::move(grasp), X_FC);
  for (CollisionShape& shape : plan.shapes) shape = moved(std::move(shape), X_FC);
  for (Look& look : plan.looks) look.X_CK = rounded(X_FC * look.X_CK);
  return plan;
}

}  // namespace quadrille

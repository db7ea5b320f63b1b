#pragma once

#include <memory>

#include "lab/physics/bullet/object_shape.hpp"
#include "lab/physics/trial.hpp"

namespace quadrille::physics {

/// The object of a trial as a rigid body in frame G.
class Thing {
 public:
  Thing(const TrueBody& body, const Eigen::Isometry3d& X_GS, const TrialOptions& options);

  btRigidBody* rigid() { return rigid_.get(); }
  /// Pose of the centre of mass, with axes that start out parallel to those of S.
  Eigen::Isometry3d X_GB() const { return unscaled(rigid_->getWorldTransform()); }
  /// Applies an acceleration to the object, as to everything but the hand [m/s²].
  void accelerate(const Eigen::Vector3d& a_G) { rigid_->setGravity(scaled(a_G)); }
  /// Props the object up, so that it neither falls nor keeps moving by itself.
  void prop(bool propped);

 private:
  MassProperties mass_;
  ObjectShape shape_;
  std::unique_ptr<btRigidBody> rigid_;
};

/// The plane on which the object stands.
class Table {
 public:
  explicit Table(const Eigen::Isometry3d& X_GT);

  btRigidBody* rigid() { return rigid_.get(); }

 private:
  std::unique_ptr<btStaticPlaneShape> shape_;
  std::unique_ptr<btRigidBody> rigid_;
};

/// Returns true if the object rests in place without a hand: 0.2 s of gravity move it by less than
/// 2 mm and 2°.
bool stands(const TrueBody& body, const Eigen::Isometry3d& X_CT, const TrialOptions& options);

constexpr double kGravity = 9.81;

}  // namespace quadrille::physics

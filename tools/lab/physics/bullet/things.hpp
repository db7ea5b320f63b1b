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
  /// Pose of its centre of mass, axes as those of S at first.
  Eigen::Isometry3d X_GB() const { return unscaled(rigid_->getWorldTransform()); }
  /// Everything but the hand feels an acceleration [m/s²].
  void accelerate(const Eigen::Vector3d& a_G) { rigid_->setGravity(scaled(a_G)); }
  /// Propped up: it neither falls nor keeps moving by itself.
  void prop(bool propped);

 private:
  MassProperties mass_;
  ObjectShape shape_;
  std::unique_ptr<btRigidBody> rigid_;
};

/// The plane that it stands on.
class Table {
 public:
  explicit Table(const Eigen::Isometry3d& X_GT);

  btRigidBody* rigid() { return rigid_.get(); }

 private:
  std::unique_ptr<btStaticPlaneShape> shape_;
  std::unique_ptr<btRigidBody> rigid_;
};

/// True if the object rests where it is, without any hand: 0.2 s of gravity move it by less than
/// 2 mm and 2°.
bool stands(const TrueBody& body, const Eigen::Isometry3d& X_CT, const TrialOptions& options);

constexpr double kGravity = 9.81;

}  // namespace quadrille::physics

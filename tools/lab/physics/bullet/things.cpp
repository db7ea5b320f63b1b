#include "lab/physics/bullet/things.hpp"

#include "lab/physics/bullet/world.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

// Time for which an object is watched [s], and how far it may move and turn meanwhile [m, rad].
constexpr double kWatched = 0.2, kMaxWay = 0.002, kMaxTurn = 0.035;

}  // namespace

Thing::Thing(const TrueBody& body, const Eigen::Isometry3d& X_GS, const TrialOptions& options)
    : mass_(mass_properties(body, options.density)),
      shape_(make_object_shape(body, mass_.centre_S)) {
  rigid_ = std::make_unique<btRigidBody>(mass_.mass, nullptr, shape_.shape(),
                                         to_bullet(kScale * kScale * mass_.inertia));
  Eigen::Isometry3d X_GB = X_GS;
  X_GB.translation() = X_GS * mass_.centre_S;
  rigid_->setWorldTransform(scaled(X_GB));
  // Bullet multiplies the frictions of two bodies, so this one alone carries the coefficient.
  rigid_->setFriction(options.friction);
  rigid_->setActivationState(DISABLE_DEACTIVATION);
}

void Thing::prop(bool propped) {
  const double damping = propped ? 1.0 : 0.0;
  rigid_->setDamping(damping, damping);
}

Table::Table(const Eigen::Isometry3d& X_GT) {
  const Vector3d n = X_GT.linear().col(2);
  shape_ = std::make_unique<btStaticPlaneShape>(to_bullet(n),
                                                kScale * n.dot(Vector3d(X_GT.translation())));
  rigid_ = std::make_unique<btRigidBody>(0.0, nullptr, shape_.get());
  rigid_->setFriction(1.0);
}

bool stands(const TrueBody& body, const Eigen::Isometry3d& X_CT, const TrialOptions& options) {
  World world;
  Thing thing(body, body.X_CS, options);
  Table table(X_CT);
  world->addRigidBody(thing.rigid());
  world->addRigidBody(table.rigid());
  const Eigen::Isometry3d before = thing.X_GB();
  thing.accelerate(-kGravity * X_CT.linear().col(2));
  for (double t = 0.0; t < kWatched; t += kStep) world.step();
  const Eigen::Isometry3d moved = before.inverse() * thing.X_GB();
  world->removeRigidBody(thing.rigid());
  world->removeRigidBody(table.rigid());
  return moved.translation().norm() < kMaxWay &&
         Eigen::AngleAxisd(moved.linear()).angle() < kMaxTurn;
}

}  // namespace quadrille::physics

#include "lab/physics/bullet/jaws.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

// Mass of one finger [kg], and its closing speed [m/s].
constexpr double kFingerMass = 0.2, kSpeed = 0.05;
// A soft pad touches on a disc whose radius is this share of the pad's width. A disc under even
// pressure resists twisting with 2/3 of its radius times the friction.
constexpr double kDisc = 0.25;

double twist_radius(const Gripper& gripper) { return 2.0 / 3.0 * kDisc * gripper.pad.minCoeff(); }

}  // namespace

Jaws::Jaws(btDiscreteDynamicsWorld* world, const Gripper& gripper, double preshape, double width)
    : world_(world), thickness_(gripper.finger.y()) {
  const double length = gripper.finger_front + gripper.reach(width);
  finger_shape_ = std::make_unique<btBoxShape>(
      scaled(Vector3d(0.5 * gripper.finger.x(), 0.5 * thickness_, 0.5 * length)));
  finger_shape_->setMargin(kMargin);
  palm_shape_ = std::make_unique<btBoxShape>(scaled(Vector3d(0.5 * gripper.palm)));
  palm_shape_->setMargin(kMargin);
  add_palm(gripper, width);
  for (int i = 0; i < 2; ++i) add_finger(i, gripper, preshape, width);
}

Jaws::~Jaws() {
  for (int i = 0; i < 2; ++i) {
    world_->removeConstraint(drives_[i].get());
    world_->removeRigidBody(fingers_[i].get());
  }
  world_->removeRigidBody(palm_.get());
}

void Jaws::add_palm(const Gripper& gripper, double width) {
  palm_ = std::make_unique<btRigidBody>(0.0, nullptr, palm_shape_.get());
  const double middle = -gripper.reach(width) - 0.5 * gripper.palm.z();
  palm_->setWorldTransform(moved_by({0, 0, middle}));
  palm_->setFriction(1.0);
  world_->addRigidBody(palm_.get(), kHandGroup, kObjectGroup);
}

void Jaws::add_finger(int i, const Gripper& gripper, double preshape, double width) {
  const double side = i == 0 ? 1.0 : -1.0;
  fingers_[i] =
      std::make_unique<btRigidBody>(kFingerMass, nullptr, finger_shape_.get(), btVector3(1, 1, 1));
  btRigidBody& finger = *fingers_[i];
  const double middle = 0.5 * (gripper.finger_front - gripper.reach(width));
  finger.setWorldTransform(moved_by({0, side * 0.5 * (preshape + thickness_), middle}));
  finger.setLinearFactor({0, 1, 0});
  finger.setAngularFactor({0, 0, 0});
  finger.setActivationState(DISABLE_DEACTIVATION);
  // Bullet multiplies the frictions of two bodies, so the object alone carries the coefficient.
  finger.setFriction(1.0);
  finger.setSpinningFriction(kScale * twist_radius(gripper));
  // Bullet applies spinning friction only if there is some rolling friction, so that is set to
  // almost nothing.
  finger.setRollingFriction(1e-9);
  world_->addRigidBody(&finger, kHandGroup, kObjectGroup);
  finger.setGravity({0, 0, 0});
  // The drive moves along the x axis of its frame, which points to the middle.
  const btTransform inward(btQuaternion(btVector3(0, 0, 1), -side * SIMD_HALF_PI),
                           btVector3(0, 0, 0));
  drives_[i] = std::make_unique<btSliderConstraint>(finger, inward, true);
  drives_[i]->setPoweredLinMotor(true);
  drives_[i]->setTargetLinMotorVelocity(kScale * kSpeed);
  world_->addConstraint(drives_[i].get());
}

void Jaws::set_force(double force) {
  for (auto& drive : drives_) drive->setMaxLinMotorForce(kScale * force);
}

void Jaws::couple() {
  btTransform X_0 = fingers_[0]->getWorldTransform(), X_1 = fingers_[1]->getWorldTransform();
  const double half = 0.5 * (X_0.getOrigin().y() - X_1.getOrigin().y());
  const double speed =
      0.5 * (fingers_[0]->getLinearVelocity().y() - fingers_[1]->getLinearVelocity().y());
  X_0.getOrigin().setY(half);
  X_1.getOrigin().setY(-half);
  fingers_[0]->setWorldTransform(X_0);
  fingers_[1]->setWorldTransform(X_1);
  fingers_[0]->setLinearVelocity({0, speed, 0});
  fingers_[1]->setLinearVelocity({0, -speed, 0});
}

double Jaws::opening() const {
  const double between = fingers_[0]->getWorldTransform().getOrigin().y() -
                         fingers_[1]->getWorldTransform().getOrigin().y();
  return between / kScale - thickness_;
}

}  // namespace quadrille::physics

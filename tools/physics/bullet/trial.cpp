#include "physics/trial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/bullet/jaws.hpp"
#include "physics/bullet/object_shape.hpp"
#include "physics/bullet/world.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.81;
// The pads close gently until both touch, then press [N].
constexpr double kGentle = 5.0;
// Longest time to close, and how long each later phase takes [s].
constexpr double kClosing = 2.0, kSqueeze = 0.15, kSettle = 0.1, kLift = 0.4, kShake = 0.3;
// Acceleration of the lift [m/s²]; amplitude of the shake over gravity, and its frequency [Hz].
constexpr double kLiftAcceleration = 2.0, kShakeShare = 0.5, kShakeRate = 10.0 / 3.0;
// An object that moved farther is not in the hand any more [m].
constexpr double kLost = 0.03;

/// One grasp from the pre-shape to the end of the shake.
class Trial {
 public:
  Trial(const TrueBody& body, const Gripper& gripper, const Grasp& grasp,
        const Eigen::Isometry3d& X_CT, const TrialOptions& options)
      : gripper_(gripper),
        force_(options.force > 0.0 ? options.force : gripper.max_force),
        down_G_(-(grasp.X_CG.linear().transpose() * X_CT.linear().col(2))),
        mass_(mass_properties(body, options.density)),
        shape_(make_object_shape(body, mass_.centre_S)),
        jaws_(world_.get(), gripper, grasp.preshape, grasp.width) {
    add_object(grasp.X_CG.inverse() * body.X_CS, options.friction);
    add_table(grasp.X_CG.inverse() * X_CT);
  }
  ~Trial() {
    world_->removeRigidBody(object_.get());
    if (table_) world_->removeRigidBody(table_.get());
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  TrialResult run() {
    if (close()) {
      result_.touched = true;
      squeeze();
      lift_and_shake();
    }
    return result_;
  }

 private:
  void add_object(const Eigen::Isometry3d& X_GS, double friction) {
    object_ = std::make_unique<btRigidBody>(mass_.mass, nullptr, shape_.shape(),
                                            to_bullet(kScale * kScale * mass_.inertia));
    Eigen::Isometry3d X_GB = X_GS;
    X_GB.translation() = X_GS * mass_.centre_S;
    object_->setWorldTransform(scaled(X_GB));
    object_->setFriction(friction);
    object_->setActivationState(DISABLE_DEACTIVATION);
    world_->addRigidBody(object_.get(), kObjectGroup, kHandGroup | kTableGroup);
    // Weightless, and as slow as a thing that is pushed over a table.
    object_->setGravity({0, 0, 0});
    object_->setDamping(1.0, 1.0);
  }

  void add_table(const Eigen::Isometry3d& X_GT) {
    const Vector3d n = X_GT.linear().col(2);
    table_shape_ = std::make_unique<btStaticPlaneShape>(
        to_bullet(n), kScale * n.dot(Vector3d(X_GT.translation())));
    table_ = std::make_unique<btRigidBody>(0.0, nullptr, table_shape_.get());
    table_->setFriction(1.0);
    world_->addRigidBody(table_.get(), kTableGroup, kObjectGroup);
  }

  // The whole world feels an acceleration, but for the hand.
  void accelerate(const Vector3d& a_G) { object_->setGravity(scaled(a_G)); }

  bool touches(int finger) const { return world_.touch(jaws_.finger(finger), object_.get()); }

  void step() {
    world_.step();
    jaws_.couple();
    if (!first_touch_ && (touches(0) || touches(1))) {
      first_touch_ = true;
      X_GB_ = unscaled(object_->getWorldTransform());
    }
    if (first_touch_) measure();
  }

  // What has become of the pose at the first touch.
  void measure() {
    const Eigen::Isometry3d X_GB = unscaled(object_->getWorldTransform());
    const Eigen::Isometry3d moved = X_GB * X_GB_.inverse();
    const Vector3d way = moved.translation();  // of the point that was midway between the pads
    slip_ = Eigen::Vector2d(way.x(), way.z()).norm();
    result_.slip = std::max(result_.slip, slip_);
    result_.rotation = std::max(result_.rotation, Eigen::AngleAxisd(moved.linear()).angle());
  }

  // False if the pads meet or stop before both touch.
  bool close() {
    jaws_.set_force(std::min(kGentle, force_));
    int both = 0;
    for (double t = 0.0; t < kClosing; t += kStep) {
      step();
      both = touches(0) && touches(1) ? both + 1 : 0;
      if (both == 10) return true;
      if (jaws_.opening() <= gripper_.min_opening) return false;
    }
    return false;
  }

  void squeeze() {
    const double gentle = std::min(kGentle, force_);
    for (double t = 0.0; t < kSqueeze; t += kStep) {
      jaws_.set_force(gentle + std::min(1.0, 2.0 * t / kSqueeze) * (force_ - gentle));
      step();
    }
    jaws_.set_force(force_);
    object_->setDamping(0.0, 0.0);
    for (double t = 0.0; t < kSettle; t += kStep) {
      accelerate(std::min(1.0, 2.0 * t / kSettle) * kGravity * down_G_);
      step();
    }
  }

  void lift_and_shake() {
    world_->removeRigidBody(table_.get());
    table_.reset();
    for (double t = 0.0; t < kLift; t += kStep) {
      const double up = t < 0.5 * kLift ? kLiftAcceleration : -kLiftAcceleration;
      accelerate((kGravity + up) * down_G_);
      step();
    }
    for (int i = 0; i < 3; ++i) {
      for (double t = 0.0; t < kShake; t += kStep) {
        const double swing = std::sin(2.0 * std::numbers::pi * kShakeRate * t);
        accelerate(kGravity * (down_G_ + kShakeShare * swing * Vector3d::Unit(i)));
        step();
      }
    }
    result_.lifted = slip_ < kLost && touches(0) && touches(1);
    result_.held = result_.lifted && result_.slip < kMostSlip && result_.rotation < kMostRotation;
  }

  const Gripper& gripper_;
  double force_;
  Vector3d down_G_;
  MassProperties mass_;
  World world_;
  ObjectShape shape_;
  Jaws jaws_;
  std::unique_ptr<btRigidBody> object_, table_;
  std::unique_ptr<btStaticPlaneShape> table_shape_;
  bool first_touch_ = false;
  Eigen::Isometry3d X_GB_ = Eigen::Isometry3d::Identity();
  double slip_ = 0.0;
  TrialResult result_;
};

}  // namespace

std::string missing_physics() { return ""; }

TrialResult try_grasp(const TrueBody& body, const Gripper& gripper, const Grasp& grasp,
                      const Eigen::Isometry3d& X_CT, const TrialOptions& options) {
  gripper.check();
  options.check();
  return Trial(body, gripper, grasp, X_CT, options).run();
}

}  // namespace quadrille::physics

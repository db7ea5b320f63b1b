#include "lab/physics/trial.hpp"

#include <algorithm>
#include <cmath>

#include "lab/physics/bullet/jaws.hpp"
#include "lab/physics/bullet/things.hpp"
#include "lab/physics/bullet/world.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

// The pads close with this gentle force until both touch, and then press with full force [N].
constexpr double kGentle = 5.0;
// Longest time to close, and durations of the later phases [s].
constexpr double kClosing = 2.0, kSqueeze = 0.15, kSettle = 0.1, kLift = 0.4, kShake = 0.3;
// The pads have hold of the object after this many steps of contact with both, or 10 ms.
constexpr int kTouching = 40;
// Acceleration of the lift [m/s²]; amplitude of the shake relative to gravity, and its frequency
// [Hz].
constexpr double kLiftAcceleration = 2.0, kShakeShare = 0.5, kShakeRate = 10.0 / 3.0;
// An object that has moved farther than this is no longer in the hand [m].
constexpr double kLost = 0.03;

/// The trial of one grasp, from the pre-shape to the end of the shake.
class Trial {
 public:
  Trial(const TrueBody& body, const Gripper& gripper, const Grasp& grasp,
        const Eigen::Isometry3d& X_CT, const TrialOptions& options)
      : gripper_(gripper),
        force_(options.force > 0.0 ? options.force : gripper.max_force),
        down_G_(-(grasp.X_CG.linear().transpose() * X_CT.linear().col(2))),
        stands_(stands(body, X_CT, options)),
        thing_(body, grasp.X_CG.inverse() * body.X_CS, options),
        table_(grasp.X_CG.inverse() * X_CT),
        jaws_(world_.get(), gripper, grasp.preshape, grasp.width) {
    world_->addRigidBody(thing_.rigid(), kObjectGroup, kHandGroup | kTableGroup);
    world_->addRigidBody(table_.rigid(), kTableGroup, kObjectGroup);
    thing_.accelerate(stands_ ? Vector3d(kGravity * down_G_) : Vector3d::Zero());
    thing_.prop(!stands_);
  }
  ~Trial() {
    world_->removeRigidBody(thing_.rigid());
    world_->removeRigidBody(table_.rigid());
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  TrialResult run() {
    result_.touched = close();
    if (!result_.touched) return result_;
    squeeze();
    lift();
    shake();
    result_.lifted = slip_ < kLost && touches(0) && touches(1);
    result_.held = result_.lifted && result_.slip < kMaxSlip && result_.rotation < kMaxRotation;
    return result_;
  }

 private:
  bool touches(int finger) { return world_.touch(jaws_.finger(finger), thing_.rigid()); }

  void step() {
    world_.step();
    jaws_.couple();
    if (!first_touch_ && (touches(0) || touches(1))) {
      first_touch_ = true;
      X_GB_ = thing_.X_GB();
    }
    if (result_.touched) measure();
  }

  // Measures how the object has moved since the first touch, while both pads hold it.
  void measure() {
    const Eigen::Isometry3d moved = thing_.X_GB() * X_GB_.inverse();
    // motion of the point that was midway between the pads
    const Vector3d way = moved.translation();
    slip_ = Eigen::Vector2d(way.x(), way.z()).norm();
    result_.slip = std::max(result_.slip, slip_);
    result_.rotation = std::max(result_.rotation, Eigen::AngleAxisd(moved.linear()).angle());
  }

  // Returns false if the pads meet or stop before both touch.
  bool close() {
    jaws_.set_force(std::min(kGentle, force_));
    int both = 0;
    for (double t = 0.0; t < kClosing; t += kStep) {
      step();
      both = touches(0) && touches(1) ? both + 1 : 0;
      if (both == kTouching) return true;
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
    thing_.prop(false);
    for (double t = 0.0; t < kSettle; t += kStep) {
      const double share = stands_ ? 1.0 : std::min(1.0, 2.0 * t / kSettle);
      thing_.accelerate(share * kGravity * down_G_);
      step();
    }
  }

  void lift() {
    world_->removeRigidBody(table_.rigid());
    for (double t = 0.0; t < kLift; t += kStep) {
      const double up = t < 0.5 * kLift ? kLiftAcceleration : -kLiftAcceleration;
      thing_.accelerate((kGravity + up) * down_G_);
      step();
    }
  }

  void shake() {
    for (int i = 0; i < 3; ++i) {
      for (double t = 0.0; t < kShake; t += kStep) {
        const double swing = std::sin(2.0 * std::numbers::pi * kShakeRate * t);
        thing_.accelerate(kGravity * (down_G_ + kShakeShare * swing * Vector3d::Unit(i)));
        step();
      }
    }
  }

  const Gripper& gripper_;
  double force_;
  Vector3d down_G_;
  bool stands_;
  World world_;
  Thing thing_;
  Table table_;
  Jaws jaws_;
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

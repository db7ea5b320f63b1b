#pragma once

#include <array>
#include <memory>

#include "lab/physics/bullet/units.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille::physics {

/// Groups that decide which bodies can collide.
enum CollisionGroup { kHandGroup = 1, kTableGroup = 2, kObjectGroup = 4 };

/// Two fingers that slide along y of the world, which is the grasp frame G, and a palm at rest.
class Jaws {
 public:
  /// @param preshape  distance between the pads [m]
  /// @param width  distance between the pads for which the palm is placed [m]
  Jaws(btDiscreteDynamicsWorld* world, const Gripper& gripper, double preshape, double width);
  ~Jaws();
  Jaws(const Jaws&) = delete;
  Jaws& operator=(const Jaws&) = delete;

  /// Both fingers close with at most this force [N].
  void set_force(double force);
  /// Moves both fingers equally far from the middle, as the hand's drive does. Call this after each
  /// step.
  void couple();
  /// Distance between the pads [m].
  double opening() const;
  const btCollisionObject* finger(int i) const { return fingers_[i].get(); }

 private:
  void add_finger(int i, const Gripper& gripper, double preshape, double width);
  void add_palm(const Gripper& gripper, double width);

  btDiscreteDynamicsWorld* world_;
  double thickness_;
  std::unique_ptr<btBoxShape> finger_shape_, palm_shape_;
  std::unique_ptr<btRigidBody> palm_;
  std::array<std::unique_ptr<btRigidBody>, 2> fingers_;
  std::array<std::unique_ptr<btSliderConstraint>, 2> drives_;
};

}  // namespace quadrille::physics

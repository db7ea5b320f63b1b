#pragma once

#include <memory>

#include "lab/physics/bullet/units.hpp"

namespace quadrille::physics {

/// Bullet's world with all that it needs, set for few, slow, firmly held bodies.
class World {
 public:
  World();

  btDiscreteDynamicsWorld* operator->() { return world_.get(); }
  btDiscreteDynamicsWorld* get() { return world_.get(); }
  /// True if two bodies touch.
  bool touch(const btCollisionObject* a, const btCollisionObject* b) const;
  /// One step of a quarter of a millisecond.
  void step();

 private:
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  std::unique_ptr<btDbvtBroadphase> broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
};

/// Length of a step [s]. Light things under much force need short ones: at 1 ms the solver's 60
/// rounds leave so much of 235 N that objects creep in the hand; ten times as many rounds, or
/// steps of 0.1 ms, give what these give.
constexpr double kStep = 0.00025;

}  // namespace quadrille::physics

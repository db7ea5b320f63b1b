#pragma once

#include <memory>

#include "lab/physics/bullet/units.hpp"

namespace quadrille::physics {

/// Bullet's world with all its parts, configured for few, slow, firmly held bodies.
class World {
 public:
  World();

  btDiscreteDynamicsWorld* operator->() { return world_.get(); }
  btDiscreteDynamicsWorld* get() { return world_.get(); }
  /// Returns true if two bodies touch.
  bool touch(const btCollisionObject* a, const btCollisionObject* b) const;
  /// Simulates one step of a quarter of a millisecond.
  void step();

 private:
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  std::unique_ptr<btDbvtBroadphase> broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
};

/// Length of a step [s]. Light objects under large forces need short steps: at 1 ms the solver's 60
/// iterations leave such an error under 235 N that objects creep in the hand. Ten times as many
/// iterations, or steps of 0.1 ms, give the same results as this.
constexpr double kStep = 0.00025;

}  // namespace quadrille::physics

#pragma once

#include <memory>

#include "physics/bullet/units.hpp"

namespace quadrille::physics {

/// Bullet's world with all that it needs, set for few, slow, firmly held bodies.
class World {
 public:
  World();

  btDiscreteDynamicsWorld* operator->() { return world_.get(); }
  btDiscreteDynamicsWorld* get() { return world_.get(); }
  /// True if two bodies touch.
  bool touch(const btCollisionObject* a, const btCollisionObject* b) const;
  /// One step of 1 ms.
  void step();

 private:
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  std::unique_ptr<btDbvtBroadphase> broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
};

/// Length of a step [s].
constexpr double kStep = 0.001;

}  // namespace quadrille::physics

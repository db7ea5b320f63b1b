#include "lab/physics/bullet/world.hpp"

#include "lab/physics/bullet/wall_shape.hpp"

namespace quadrille::physics {
namespace {

// A contact counts as touching from this distance on [scaled m].
constexpr double kTouch = kScale * 0.00005;
// Share of a penetration that one step corrects. Bullet's own 0.2 is meant for a step of a
// millisecond.
constexpr double kCorrected = 0.05;

}  // namespace

World::World() {
  configuration_ = std::make_unique<btDefaultCollisionConfiguration>();
  // This gives flat and straight contacts all of their points at once.
  configuration_->setConvexConvexMultipointIterations(4, 4);
  dispatcher_ = std::make_unique<btCollisionDispatcher>(configuration_.get());
  register_wall_contacts(dispatcher_.get());
  broadphase_ = std::make_unique<btDbvtBroadphase>();
  solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
  world_ = std::make_unique<btDiscreteDynamicsWorld>(dispatcher_.get(), broadphase_.get(),
                                                     solver_.get(), configuration_.get());
  world_->setGravity({0, 0, 0});
  btContactSolverInfo& info = world_->getSolverInfo();
  info.m_numIterations = 60;
  info.m_erp = info.m_erp2 = kCorrected;
  info.m_solverMode = SOLVER_USE_WARMSTARTING | SOLVER_USE_2_FRICTION_DIRECTIONS |
                      SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS;
}

bool World::touch(const btCollisionObject* a, const btCollisionObject* b) const {
  for (int i = 0; i < dispatcher_->getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = dispatcher_->getManifoldByIndexInternal(i);
    const auto* first = manifold->getBody0();
    const auto* second = manifold->getBody1();
    if (!((first == a && second == b) || (first == b && second == a))) continue;
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      if (manifold->getContactPoint(k).getDistance() < kTouch) return true;
    }
  }
  return false;
}

void World::step() { world_->stepSimulation(kStep, 0); }

}  // namespace quadrille::physics

#pragma once

#include "lab/physics/bullet/units.hpp"
#include "lab/physics/true_body.hpp"

namespace quadrille::physics {

/// A hollow body for Bullet. Boxes and planes touch it only through wall contacts; see
/// register_wall_contacts().
class WallShape : public btConcaveShape {
 public:
  /// @param centre_S  point of the axis that becomes the origin of the shape [m]
  WallShape(TrueBody body, const Eigen::Vector3d& centre_S);

  const TrueBody& body() const { return body_; }
  const Eigen::Vector3d& centre_S() const { return centre_S_; }

  void getAabb(const btTransform& X, btVector3& low, btVector3& high) const override;
  /// Does nothing, because the wall has no triangles.
  void processAllTriangles(btTriangleCallback*, const btVector3&, const btVector3&) const override {
  }
  void setLocalScaling(const btVector3&) override {}
  const btVector3& getLocalScaling() const override { return one_; }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override {
    inertia.setValue(0.0, 0.0, 0.0);
  }
  const char* getName() const override { return "Wall"; }

 private:
  TrueBody body_;
  Eigen::Vector3d centre_S_;
  btVector3 one_{1, 1, 1};
};

/// Registers the contacts of boxes and planes with walls. They consist of points: those of a fine
/// grid on the box's faces that lie in the wall, or those of the wall's two rims that lie below the
/// plane.
void register_wall_contacts(btCollisionDispatcher* dispatcher);

}  // namespace quadrille::physics

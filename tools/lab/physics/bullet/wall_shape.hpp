#pragma once

#include "lab/physics/bullet/units.hpp"
#include "lab/physics/true_body.hpp"

namespace quadrille::physics {

/// A hollow body for Bullet. Boxes and planes meet it through wall contacts alone, see
/// register_wall_contacts().
class WallShape : public btConcaveShape {
 public:
  /// @param centre_S  point of the axis that becomes the origin of the shape [m]
  WallShape(TrueBody body, const Eigen::Vector3d& centre_S);

  const TrueBody& body() const { return body_; }
  const Eigen::Vector3d& centre_S() const { return centre_S_; }

  void getAabb(const btTransform& X, btVector3& low, btVector3& high) const override;
  /// It has no triangles.
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

/// Has boxes and planes meet walls by points: those of a fine grid over the box's faces in the
/// wall, those of the wall's two rims below the plane.
void register_wall_contacts(btCollisionDispatcher* dispatcher);

}  // namespace quadrille::physics

#pragma once

#include "lab/physics/bullet/units.hpp"
#include "lab/physics/true_body.hpp"

namespace quadrille::physics {

/// A convex body between two heights, given by its exact support function. It has no collision
/// margin, since the hand's boxes have one inside theirs.
class SectionShape : public btConvexInternalShape {
 public:
  /// @param centre_S  point of the axis that becomes the origin of the shape [m]
  SectionShape(TrueBody body, double z_0, double z_1, const Eigen::Vector3d& centre_S)
      : body_(std::move(body)), z_0_(z_0), z_1_(z_1), centre_S_(centre_S) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    m_collisionMargin = 0.0;
  }

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override {
    const Eigen::Vector3d p_S = support_point(body_, z_0_, z_1_, from_bullet(direction));
    return scaled(Eigen::Vector3d(p_S - centre_S_));
  }
  btVector3 localGetSupportingVertex(const btVector3& direction) const override {
    return localGetSupportingVertexWithoutMargin(direction);
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions,
                                                         btVector3* points,
                                                         int count) const override {
    for (int i = 0; i < count; ++i) {
      points[i] = localGetSupportingVertexWithoutMargin(directions[i]);
    }
  }
  /// Never used, because the masses are computed outside of Bullet.
  void calculateLocalInertia(btScalar, btVector3& inertia) const override {
    inertia.setValue(0.0, 0.0, 0.0);
  }
  const char* getName() const override { return "Section"; }

 private:
  TrueBody body_;
  double z_0_, z_1_;
  Eigen::Vector3d centre_S_;
};

}  // namespace quadrille::physics

#pragma once

#include <btBulletDynamicsCommon.h>

#include <Eigen/Geometry>

namespace quadrille::physics {

/// Bullet works best with objects of about one unit, so lengths are in decimetres. Forces scale
/// like lengths, torques and moments of inertia like their squares.
constexpr double kScale = 10.0;
/// Bullet's boxes and cylinders keep their size, but their edges are rounded within this distance.
constexpr double kMargin = kScale * 0.0005;

inline btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline btVector3 scaled(const Eigen::Vector3d& p) { return to_bullet(kScale * p); }
inline Eigen::Vector3d from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

inline btTransform moved_by(const Eigen::Vector3d& p) {
  return btTransform(btQuaternion::getIdentity(), scaled(p));
}

inline btTransform scaled(const Eigen::Isometry3d& X) {
  const Eigen::Quaterniond q(X.linear());
  return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()),
                     scaled(Eigen::Vector3d(X.translation())));
}

inline Eigen::Isometry3d unscaled(const btTransform& X) {
  const btQuaternion q = X.getRotation();
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized().toRotationMatrix();
  result.translation() = from_bullet(X.getOrigin()) / kScale;
  return result;
}

}  // namespace quadrille::physics

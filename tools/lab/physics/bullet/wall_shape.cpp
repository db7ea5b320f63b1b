#include "lab/physics/bullet/wall_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "lab/physics/wall.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

// Spacing of the points on a box [m], unless the box is so large that this would exceed the limit
// per side.
constexpr double kGrid = 0.00125;
constexpr int kMaxPoints = 45;
// Points nearer than this may touch, and points within this distance of the nearest one count as
// equally near [m].
constexpr double kNear = 0.0008, kAlike = 0.001;
constexpr int kRimPoints = 48;

/// A contact point on the other body, with the normal out of the wall; in frame S, unscaled.
struct Contact {
  Vector3d p_S, normal_S;
  double distance;
};

// Chooses at most four contacts: the deepest, the farthest from it, and the farthest on either side
// of the line between them.
std::vector<Contact> chosen(const std::vector<Contact>& all) {
  if (all.size() <= 4) return all;
  const auto better = [&](auto&& value) {
    return *std::max_element(all.begin(), all.end(), [&](const Contact& a, const Contact& b) {
      return value(a) < value(b);
    });
  };
  const Contact deepest = better([](const Contact& c) { return -c.distance; });
  const Contact far = better([&](const Contact& c) { return (c.p_S - deepest.p_S).squaredNorm(); });
  const Vector3d across = (far.p_S - deepest.p_S).cross(deepest.normal_S);
  const auto beside = [&](const Contact& c) { return across.dot(c.p_S - deepest.p_S); };
  return {deepest, far, better(beside), better([&](const Contact& c) { return -beside(c); })};
}

// Returns the contacts that touch, or are as near as the nearest.
std::vector<Contact> touching(std::vector<Contact> near) {
  double least = kNear;
  for (const Contact& c : near) least = std::min(least, c.distance);
  std::erase_if(near, [&](const Contact& c) { return c.distance > std::max(0.0, least) + kAlike; });
  return chosen(near);
}

// Adds the points on one face of a box; `axis` is the axis of its normal, `side` the normal's sign.
void add_face(const TrueBody& body, const Eigen::Isometry3d& X_SB, const Vector3d& half, int axis,
              double side, std::vector<Contact>* near) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto count = [&](int i) {
    return std::clamp(static_cast<int>(2.0 * half[i] / kGrid), 2, kMaxPoints);
  };
  const int rows = count(v), columns = count(u);
  Vector3d p = Vector3d::Zero();
  p[axis] = side * half[axis];
  for (int row = 0; row <= rows; ++row) {
    p[v] = half[v] * (2.0 * row / rows - 1.0);
    p[u] = 0.0;
    // The distance to the wall changes by hardly more than the distance moved, so far rows are
    // skipped.
    if (wall_distance(body, X_SB * p).distance > 1.5 * half[u] + kNear) continue;
    for (int column = 0; column <= columns; ++column) {
      p[u] = half[u] * (2.0 * column / columns - 1.0);
      const Vector3d p_S = X_SB * p;
      const WallDistance wall = wall_distance(body, p_S);
      if (wall.distance > kNear) continue;
      const bool edge = row == 0 || row == rows || column == 0 || column == columns;
      const Vector3d inward = -side * X_SB.linear().col(axis);
      // Inside a face, the contact normal is that of the face; at an edge, it is that of the wall.
      if (edge) near->push_back({p_S, wall.normal_S, wall.distance});
      if (!edge && wall.normal_S.dot(inward) > 0.5) near->push_back({p_S, inward, wall.distance});
    }
  }
}

std::vector<Contact> contacts_of(const WallShape& wall, const Eigen::Isometry3d& X_WS,
                                 const btBoxShape& box, const Eigen::Isometry3d& X_WB) {
  const Vector3d half = from_bullet(box.getHalfExtentsWithMargin()) / kScale;
  const Eigen::Isometry3d X_SB = X_WS.inverse() * X_WB;
  std::vector<Contact> near;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      add_face(wall.body(), X_SB, half, axis, side, &near);
    }
  }
  return touching(std::move(near));
}

std::vector<Contact> contacts_of(const WallShape& wall, const Eigen::Isometry3d& X_WS,
                                 const btStaticPlaneShape& plane, const Eigen::Isometry3d& X_WP) {
  const Eigen::Isometry3d X_SP = X_WS.inverse() * X_WP;
  const Vector3d n_S = X_SP.linear() * from_bullet(plane.getPlaneNormal());
  const double constant = plane.getPlaneConstant() / kScale + n_S.dot(Vector3d(X_SP.translation()));
  const TrueBody& body = wall.body();
  std::vector<Contact> near;
  for (const double z : {body.z_min(), body.z_max()}) {
    for (int k = 0; k < kRimPoints; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kRimPoints;
      for (const double side : {-0.5, 0.5}) {
        Vector3d p =
            body.point_S(angle, z) + (side * body.wall + body.wall_at) * body.normal_S(angle, z);
        p.z() = z;
        const double distance = n_S.dot(p) - constant;
        if (distance < kNear) near.push_back({p - distance * n_S, -n_S, distance});
      }
    }
  }
  return touching(std::move(near));
}

/// The interface to Bullet: finds which body is the wall, and passes on the contacts.
class WallAlgorithm : public btActivatingCollisionAlgorithm {
 public:
  WallAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second)
      : btActivatingCollisionAlgorithm(info, first, second),
        manifold_(m_dispatcher->getNewManifold(first->getCollisionObject(),
                                               second->getCollisionObject())) {}
  ~WallAlgorithm() override { m_dispatcher->releaseManifold(manifold_); }

  void processCollision(const btCollisionObjectWrapper* first,
                        const btCollisionObjectWrapper* second, const btDispatcherInfo&,
                        btManifoldResult* result) override {
    result->setPersistentManifold(manifold_);
    const bool swapped = first->getCollisionShape()->getShapeType() == CUSTOM_CONCAVE_SHAPE_TYPE;
    const auto* wall = swapped ? first : second;
    const auto* other = swapped ? second : first;
    const auto& shape = *static_cast<const WallShape*>(wall->getCollisionShape());
    Eigen::Isometry3d X_WS = unscaled(wall->getWorldTransform());
    X_WS.translation() -= X_WS.linear() * shape.centre_S();
    for (const Contact& contact : contacts(shape, X_WS, *other)) {
      const Vector3d n = X_WS.linear() * contact.normal_S, p = X_WS * contact.p_S;
      const Vector3d on_wall = p - contact.distance * n;
      // For Bullet, the normal points from the second body to the first, and the point lies on the
      // second.
      result->addContactPoint(to_bullet(swapped ? Vector3d(-n) : n), scaled(swapped ? p : on_wall),
                              kScale * contact.distance);
    }
    result->refreshContactPoints();
  }
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1.0;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override {
    manifolds.push_back(manifold_);
  }

 private:
  static std::vector<Contact> contacts(const WallShape& wall, const Eigen::Isometry3d& X_WS,
                                       const btCollisionObjectWrapper& other) {
    const Eigen::Isometry3d X_WO = unscaled(other.getWorldTransform());
    const btCollisionShape* shape = other.getCollisionShape();
    if (shape->getShapeType() == BOX_SHAPE_PROXYTYPE) {
      return contacts_of(wall, X_WS, *static_cast<const btBoxShape*>(shape), X_WO);
    }
    return contacts_of(wall, X_WS, *static_cast<const btStaticPlaneShape*>(shape), X_WO);
  }

  btPersistentManifold* manifold_;
};

struct MakeWallAlgorithm : btCollisionAlgorithmCreateFunc {
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* first,
                                                 const btCollisionObjectWrapper* second) override {
    void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(WallAlgorithm));
    return new (memory) WallAlgorithm(info, first, second);
  }
};

}  // namespace

WallShape::WallShape(TrueBody body, const Vector3d& centre_S)
    : body_(std::move(body)), centre_S_(centre_S) {
  m_shapeType = CUSTOM_CONCAVE_SHAPE_TYPE;
  m_collisionMargin = 0.0;
}

void WallShape::getAabb(const btTransform& X, btVector3& low, btVector3& high) const {
  const double beyond = 0.5 * body_.wall + std::abs(body_.wall_at);
  const btVector3 wall = scaled(Vector3d(Vector3d::Constant(beyond)));
  btTransformAabb(scaled(Vector3d(body_.box_S.min() - centre_S_)) - wall,
                  scaled(Vector3d(body_.box_S.max() - centre_S_)) + wall, kMargin, X, low, high);
}

void register_wall_contacts(btCollisionDispatcher* dispatcher) {
  static MakeWallAlgorithm make;
  for (const int other : {BOX_SHAPE_PROXYTYPE, STATIC_PLANE_PROXYTYPE}) {
    dispatcher->registerCollisionCreateFunc(other, CUSTOM_CONCAVE_SHAPE_TYPE, &make);
    dispatcher->registerCollisionCreateFunc(CUSTOM_CONCAVE_SHAPE_TYPE, other, &make);
  }
}

}  // namespace quadrille::physics

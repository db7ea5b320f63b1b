#pragma once

#include <memory>
#include <vector>

#include "lab/physics/bullet/units.hpp"
#include "lab/physics/true_body.hpp"

namespace quadrille::physics {

/// A collision shape and the parts that it is made of.
struct ObjectShape {
  std::vector<std::unique_ptr<btCollisionShape>> parts;
  std::unique_ptr<btCompoundShape> compound;

  btCollisionShape* shape() const { return compound ? compound.get() : parts.front().get(); }
};

/// Makes the shape of a true body about a point of its axis, in scaled units: Bullet's own box,
/// sphere or cylinder; the exact support function of any other convex body; stacked frusta for a
/// solid with a waist; and the smooth wall of a hollow body.
ObjectShape make_object_shape(const TrueBody& body, const Eigen::Vector3d& centre_S);

}  // namespace quadrille::physics

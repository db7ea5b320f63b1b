// The geometry of shapes that users give.
#include <utility>

#include "body/geometry.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille {

CollisionShape with_geometry(SolidShape solid) {
  solid.check();
  CollisionShape shape;
  static_cast<SolidShape&>(shape) = std::move(solid);
  set_geometry(shape);
  return shape;
}

}  // namespace quadrille

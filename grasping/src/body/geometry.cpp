#include "body/geometry.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>

#include <memory>
#include <vector>

namespace quadrille {
namespace {

std::shared_ptr<fcl::CollisionGeometryd> convex(const CollisionShape& shape) {
  int count = 0;
  for (std::size_t at = 0; at < shape.faces.size(); at += 1 + shape.faces[at]) ++count;
  return std::make_shared<fcl::Convexd>(
      std::make_shared<const std::vector<Eigen::Vector3d>>(shape.vertices_S), count,
      std::make_shared<const std::vector<int>>(shape.faces));
}

std::shared_ptr<fcl::CollisionGeometryd> geometry_of(const CollisionShape& shape) {
  const std::vector<double>& d = shape.dimensions;
  if (shape.kind == "sphere") return std::make_shared<fcl::Sphered>(d[0]);
  if (shape.kind == "ellipsoid") return std::make_shared<fcl::Ellipsoidd>(d[0], d[1], d[2]);
  if (shape.kind == "capsule") return std::make_shared<fcl::Capsuled>(d[0], d[1]);
  if (shape.kind == "cylinder") return std::make_shared<fcl::Cylinderd>(d[0], d[1]);
  if (shape.kind == "cone") return std::make_shared<fcl::Coned>(d[0], d[1]);
  if (shape.kind == "box") return std::make_shared<fcl::Boxd>(d[0], d[1], d[2]);
  return convex(shape);
}

}  // namespace

void set_geometry(CollisionShape& shape) {
  shape.geometry = geometry_of(shape);
  shape.geometry->computeLocalAABB();
}

}  // namespace quadrille

// The geometry of shapes that users give.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "quadrille/grasping/shape.hpp"

namespace quadrille {
namespace {

// No obstacle is larger [m].
constexpr double kMaxSize = 1e3;
// A solid with flat faces has at least so many vertices and faces.
constexpr std::size_t kMinVertices = 4;
constexpr int kMinFaces = 4;
// Least deviation from a rotation that is refused.
constexpr double kMaxSkew = 1e-3;

[[noreturn]] void refuse(const CollisionShape& shape, const std::string& why) {
  throw std::invalid_argument("shape of kind \"" + shape.kind + "\": " + why);
}

/// Checks the dimensions, and that there are so many.
const double* dimensions_of(const CollisionShape& shape, std::size_t count) {
  const bool good = std::all_of(shape.dimensions.begin(), shape.dimensions.end(),
                                [](double size) { return size > 0.0 && size <= kMaxSize; });
  if (shape.dimensions.size() != count || !good) {
    refuse(shape, "dimensions must be " + std::to_string(count) + " sizes of more than 0 m");
  }
  return shape.dimensions.data();
}

/// Returns the number of the faces, each given as the number of its corners and their indices.
int checked_faces(const CollisionShape& shape) {
  const auto size = static_cast<int>(shape.faces.size());
  const auto vertices = static_cast<int>(shape.vertices_S.size());
  int count = 0, at = 0;
  for (; at < size; ++count) {
    const int corners = shape.faces[at];
    if (corners < 3 || corners >= size - at) {
      refuse(shape, "each face must be the number of its corners, at least 3, and their indices");
    }
    for (int n = 1; n <= corners; ++n) {
      const int index = shape.faces[at + n];
      if (index < 0 || index >= vertices) refuse(shape, "a face names a vertex that there is not");
    }
    at += 1 + corners;
  }
  return count;
}

std::shared_ptr<fcl::CollisionGeometryd> convex(const CollisionShape& shape) {
  const bool good =
      std::all_of(shape.vertices_S.begin(), shape.vertices_S.end(),
                  [](const Eigen::Vector3d& v) { return (v.array().abs() <= kMaxSize).all(); });
  if (!good) refuse(shape, "vertices must be finite, in metres");
  const int faces = checked_faces(shape);
  if (shape.vertices_S.size() < kMinVertices || faces < kMinFaces) {
    refuse(shape, "needs the vertices and faces of a solid");
  }
  return std::make_shared<fcl::Convexd>(
      std::make_shared<const std::vector<Eigen::Vector3d>>(shape.vertices_S), faces,
      std::make_shared<const std::vector<int>>(shape.faces));
}

std::shared_ptr<fcl::CollisionGeometryd> geometry_of(const CollisionShape& shape) {
  if (shape.kind == "sphere") return std::make_shared<fcl::Sphered>(dimensions_of(shape, 1)[0]);
  if (shape.kind == "cylinder") {
    const double* d = dimensions_of(shape, 2);
    return std::make_shared<fcl::Cylinderd>(d[0], d[1]);
  }
  if (shape.kind == "cone") {
    const double* d = dimensions_of(shape, 2);
    return std::make_shared<fcl::Coned>(d[0], d[1]);
  }
  if (shape.kind == "ellipsoid") {
    const double* d = dimensions_of(shape, 3);
    return std::make_shared<fcl::Ellipsoidd>(d[0], d[1], d[2]);
  }
  if (shape.kind == "box") {
    const double* d = dimensions_of(shape, 3);
    return std::make_shared<fcl::Boxd>(d[0], d[1], d[2]);
  }
  if (shape.kind == "convex") return convex(shape);
  refuse(shape, "must be sphere, ellipsoid, cylinder, cone, box or convex");
}

}  // namespace

CollisionShape with_geometry(CollisionShape shape) {
  if (!shape.X_CS.matrix().allFinite() || !shape.X_CS.linear().isUnitary(kMaxSkew)) {
    refuse(shape, "the pose must be a finite, rigid motion");
  }
  shape.geometry = geometry_of(shape);
  shape.geometry->computeLocalAABB();
  return shape;
}

}  // namespace quadrille

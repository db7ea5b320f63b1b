#include "quadrille/detector/solid_shape.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>

namespace quadrille {
namespace {

// No shape is larger, or farther away [m].
constexpr double kMaxSize = 1e3;
// A solid with flat faces has at least so many of them, and so many vertices.
constexpr std::size_t kMinFaces = 4;
// Files round vertices, and the plane of a slender face turns with that: so far, as a share of the
// shape's size, may a vertex lie outside the plane of a face. Checks for collision use the hull.
constexpr double kBulge = 0.01;

[[noreturn]] void refuse(const SolidShape& shape, const std::string& why) {
  throw std::invalid_argument("shape of kind \"" + shape.kind + "\": " + why);
}

void check_dimensions(const SolidShape& shape) {
  const std::map<std::string, std::size_t> counts = {
      {"sphere", 1}, {"ellipsoid", 3}, {"cylinder", 2}, {"capsule", 2}, {"cone", 2}, {"box", 3}};
  const auto count = counts.find(shape.kind);
  if (count == counts.end()) {
    refuse(shape, "must be sphere, ellipsoid, cylinder, capsule, cone, box or convex");
  }
  const bool good = std::all_of(shape.dimensions.begin(), shape.dimensions.end(),
                                [](double size) { return size > 0.0 && size <= kMaxSize; });
  if (shape.dimensions.size() != count->second || !good) {
    refuse(shape, "dimensions must be " + std::to_string(count->second) +
                      (count->second == 1 ? " size" : " sizes") +
                      " of more than 0 m and at most 1000 m");
  }
}

/// Checks the faces, each given as the number of its corners and their indices.
void check_faces(const SolidShape& shape) {
  const auto size = static_cast<int>(shape.faces.size());
  const auto vertices = static_cast<int>(shape.vertices_S.size());
  std::size_t count = 0;
  for (int at = 0; at < size; ++count) {
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
  if (shape.vertices_S.size() < kMinFaces || count < kMinFaces) {
    refuse(shape, "needs the vertices and faces of a solid");
  }
}

void check_vertices(const SolidShape& shape) {
  const bool good =
      std::all_of(shape.vertices_S.begin(), shape.vertices_S.end(),
                  [](const Eigen::Vector3d& v) { return (v.array().abs() <= kMaxSize).all(); });
  if (!good) refuse(shape, "vertices must lie within 1000 m");
}

/// Checks that all vertices lie on one side of each face, since a shape with a notch would be
/// larger in checks for collision, which use its hull, than it is for points, which use its faces.
void check_convex(const SolidShape& shape) {
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& v : shape.vertices_S) bounds.extend(v);
  const double slack = kBulge * bounds.diagonal().norm();
  for (std::size_t at = 0; at < shape.faces.size(); at += 1 + shape.faces[at]) {
    const Eigen::Vector3d& a = shape.vertices_S[shape.faces[at + 1]];
    const Eigen::Vector3d& b = shape.vertices_S[shape.faces[at + 2]];
    const Eigen::Vector3d& c = shape.vertices_S[shape.faces[at + 3]];
    const Eigen::Vector3d n = (b - a).cross(c - a).stableNormalized();
    double above = 0.0, below = 0.0;
    for (const Eigen::Vector3d& v : shape.vertices_S) {
      above = std::max(above, n.dot(v - a));
      below = std::max(below, n.dot(a - v));
    }
    if (std::min(above, below) > slack) {
      refuse(shape,
             "it is not convex: vertices lie on both sides of a face; give several convex "
             "shapes instead");
    }
  }
}

}  // namespace

void SolidShape::check() const {
  if (!X_CS.matrix().allFinite() || !X_CS.linear().isUnitary(1e-3)) {
    refuse(*this, "the pose must be a finite, rigid motion");
  }
  if (kind == "convex") {
    check_vertices(*this);
    check_faces(*this);
    check_convex(*this);
  } else {
    check_dimensions(*this);
  }
}

}  // namespace quadrille

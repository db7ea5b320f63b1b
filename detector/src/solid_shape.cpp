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

}  // namespace

void SolidShape::check() const {
  if (!X_CS.matrix().allFinite() || !X_CS.linear().isUnitary(1e-3)) {
    refuse(*this, "the pose must be a finite, rigid motion");
  }
  if (kind == "convex") {
    check_vertices(*this);
    check_faces(*this);
  } else {
    check_dimensions(*this);
  }
}

}  // namespace quadrille

#include "body/polyhedron.hpp"

#include <fcl/geometry/shape/convex.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace quadrille {
namespace {

void push_face(std::vector<int>& faces, std::initializer_list<int> corners) {
  faces.push_back(static_cast<int>(corners.size()));
  faces.insert(faces.end(), corners);
}

void finish(CollisionShape& shape, int face_count) {
  shape.kind = "convex";
  shape.geometry = std::make_shared<fcl::Convexd>(
      std::make_shared<const std::vector<Eigen::Vector3d>>(shape.vertices_S), face_count,
      std::make_shared<const std::vector<int>>(shape.faces));
  shape.geometry->computeLocalAABB();
}

void push_sides(std::vector<int>& faces, int base) {
  for (int k = 0; k < kSides; ++k) {
    const int n = (k + 1) % kSides;
    push_face(faces, {base + k, base + n, base + kSides + n});
    push_face(faces, {base + k, base + kSides + n, base + kSides + k});
  }
}

}  // namespace

CollisionShape make_rings(const Body& body, const std::vector<Ring>& rings) {
  const double middle = 0.5 * (rings.front().z + rings.back().z);
  const double outward = 1.0 / std::cos(std::numbers::pi / kSides);
  CollisionShape shape;
  shape.X_CS = body.X_CQ;
  shape.X_CS.translation() = body.X_CQ * Eigen::Vector3d(0, 0, middle);
  for (const Ring& ring : rings) {
    const double s = std::max(ring.s, 1e-6);
    shape.excess = std::max(shape.excess, (outward - 1.0) * s * std::max(body.a, body.b));
    for (int k = 0; k < kSides; ++k) {
      const double t = 2.0 * std::numbers::pi * k / kSides;
      shape.vertices_S.emplace_back(body.a * s * outward * std::cos(t),
                                    body.b * s * outward * std::sin(t), ring.z - middle);
    }
  }
  const int last = kSides * (static_cast<int>(rings.size()) - 1);
  for (int base = 0; base < last; base += kSides) push_sides(shape.faces, base);
  for (const bool top : {false, true}) {
    shape.faces.push_back(kSides);
    for (int k = 0; k < kSides; ++k) shape.faces.push_back(top ? last + k : kSides - 1 - k);
  }
  finish(shape, 2 * last + 2);
  return shape;
}

CollisionShape make_block(const std::array<Eigen::Vector3d, 8>& corners_S,
                          const Eigen::Isometry3d& X_CS) {
  constexpr int kFaces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  CollisionShape shape;
  shape.X_CS = X_CS;
  shape.vertices_S.assign(corners_S.begin(), corners_S.end());
  for (const auto& face : kFaces) push_face(shape.faces, {face[0], face[1], face[2]});
  finish(shape, 12);
  return shape;
}

}  // namespace quadrille

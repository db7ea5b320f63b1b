#include "body/polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "body/geometry.hpp"

namespace quadrille {
namespace {

void push_face(std::vector<int>& faces, std::initializer_list<int> corners) {
  faces.push_back(static_cast<int>(corners.size()));
  faces.insert(faces.end(), corners);
}

CollisionShape convex(const Eigen::Isometry3d& X_CS, std::vector<Eigen::Vector3d> vertices_S,
                      std::vector<int> faces) {
  CollisionShape shape;
  shape.kind = "convex";
  shape.X_CS = X_CS;
  shape.vertices_S = std::move(vertices_S);
  shape.faces = std::move(faces);
  set_geometry(shape);
  return shape;
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
  std::vector<Eigen::Vector3d> vertices_S;
  double excess = 0.0;
  for (const Ring& ring : rings) {
    const double s = std::max(ring.s, 1e-6);
    excess = std::max(excess, (outward - 1.0) * s * std::max(body.a, body.b));
    for (int k = 0; k < kSides; ++k) {
      const double t = 2.0 * std::numbers::pi * k / kSides;
      vertices_S.emplace_back(body.a * s * outward * std::cos(t),
                              body.b * s * outward * std::sin(t), ring.z - middle);
    }
  }
  std::vector<int> faces;
  const int last = kSides * (static_cast<int>(rings.size()) - 1);
  for (int base = 0; base < last; base += kSides) push_sides(faces, base);
  for (const bool top : {false, true}) {
    faces.push_back(kSides);
    for (int k = 0; k < kSides; ++k) faces.push_back(top ? last + k : kSides - 1 - k);
  }
  Eigen::Isometry3d X_CS = body.X_CQ;
  X_CS.translation() = body.X_CQ * Eigen::Vector3d(0, 0, middle);
  CollisionShape shape = convex(X_CS, std::move(vertices_S), std::move(faces));
  shape.excess = excess;
  return shape;
}

CollisionShape make_block(const std::array<Eigen::Vector3d, 8>& corners_S,
                          const Eigen::Isometry3d& X_CS) {
  constexpr int kFaces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  std::vector<int> faces;
  for (const auto& face : kFaces) push_face(faces, {face[0], face[1], face[2]});
  return convex(X_CS, {corners_S.begin(), corners_S.end()}, std::move(faces));
}

}  // namespace quadrille

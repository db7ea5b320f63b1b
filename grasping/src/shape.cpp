#include "quadrille/grasping/shape.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

using Profile = Body::Profile;

constexpr int kSides = 24;

// Cross-section of a polyhedron that holds a body: height, and the scale of its semi-axes.
struct Ring {
  double z, s;
};

CollisionShape placed(std::string kind, const Body& body, double z) {
  CollisionShape shape;
  shape.kind = std::move(kind);
  shape.X_CS = body.X_CQ;
  shape.X_CS.translation() = body.X_CQ * Eigen::Vector3d(0, 0, z);
  return shape;
}

CollisionShape round_shape(const Body& body) {
  CollisionShape shape;
  if (body.a == body.b && body.b == body.c) {
    shape = placed("sphere", body, 0.0);
    shape.dimensions = {body.a};
    shape.geometry = std::make_shared<fcl::Sphered>(body.a);
  } else {
    shape = placed("ellipsoid", body, 0.0);
    shape.dimensions = {body.a, body.b, body.c};
    shape.geometry = std::make_shared<fcl::Ellipsoidd>(body.a, body.b, body.c);
  }
  return shape;
}

CollisionShape cylinder_shape(const Body& body) {
  CollisionShape shape = placed("cylinder", body, 0.5 * (body.z_min + body.z_max));
  shape.dimensions = {body.a, body.z_max - body.z_min};
  shape.geometry = std::make_shared<fcl::Cylinderd>(body.a, body.z_max - body.z_min);
  return shape;
}

// FCL's cone points along +z; ours opens along +z or −z from its apex at the origin.
CollisionShape cone_shape(const Body& body) {
  const double length = body.z_max - body.z_min;
  CollisionShape shape = placed("cone", body, 0.5 * (body.z_min + body.z_max));
  if (body.z_max > 0.0)
    shape.X_CS.rotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
  shape.dimensions = {body.a * length, length};
  shape.geometry = std::make_shared<fcl::Coned>(body.a * length, length);
  return shape;
}

CollisionShape box_shape(const Eigen::Isometry3d& X_CQ, const Eigen::AlignedBox3d& box_Q) {
  CollisionShape shape;
  shape.kind = "box";
  shape.X_CS = X_CQ;
  shape.X_CS.translation() = X_CQ * Eigen::Vector3d(box_Q.center());
  const Eigen::Vector3d sides = box_Q.sizes();
  shape.dimensions = {sides.x(), sides.y(), sides.z()};
  shape.geometry = std::make_shared<fcl::Boxd>(sides);
  return shape;
}

void push_face(std::vector<int>& faces, std::initializer_list<int> corners) {
  faces.push_back(static_cast<int>(corners.size()));
  faces.insert(faces.end(), corners);
}

// Rings closed by flat ends; the polygons circumscribe the ellipses.
CollisionShape ring_shape(const Body& body, const std::vector<Ring>& rings) {
  const double middle = 0.5 * (rings.front().z + rings.back().z);
  CollisionShape shape = placed("convex", body, middle);
  const double outward = 1.0 / std::cos(std::numbers::pi / kSides);
  for (const Ring& ring : rings) {
    for (int k = 0; k < kSides; ++k) {
      const double t = 2.0 * std::numbers::pi * k / kSides;
      const double s = std::max(ring.s, 1e-6) * outward;
      shape.vertices_S.emplace_back(body.a * s * std::cos(t), body.b * s * std::sin(t),
                                    ring.z - middle);
    }
  }
  const int last = kSides * (static_cast<int>(rings.size()) - 1);
  for (int base = 0; base < last; base += kSides) {
    for (int k = 0; k < kSides; ++k) {
      const int n = (k + 1) % kSides;
      push_face(shape.faces, {base + k, base + n, base + kSides + n});
      push_face(shape.faces, {base + k, base + kSides + n, base + kSides + k});
    }
  }
  for (const bool top : {false, true}) {
    shape.faces.push_back(kSides);
    for (int k = 0; k < kSides; ++k) shape.faces.push_back(top ? last + k : kSides - 1 - k);
  }
  shape.geometry = std::make_shared<fcl::Convexd>(
      std::make_shared<const std::vector<Eigen::Vector3d>>(shape.vertices_S),
      2 * kSides * (static_cast<int>(rings.size()) - 1) + 2,
      std::make_shared<const std::vector<int>>(shape.faces));
  return shape;
}

// Rings whose chords lie outside the profile: for a bulging one each is grown by the sagitta.
std::vector<Ring> enclosing_rings(const Body& body) {
  const bool bulges = body.profile == Profile::kRoot || body.profile == Profile::kSheet;
  const int steps = bulges ? 6 : 1;
  std::vector<Ring> rings;
  for (int i = 0; i <= steps; ++i) {
    // Quadratic spacing: bulging profiles bend most at their vertex.
    const double u = bulges ? static_cast<double>(i * i) / (steps * steps) : i;
    const double z = body.z_min + u * (body.z_max - body.z_min);
    rings.push_back({z, body.scale(z)});
  }
  std::vector<double> extra(rings.size(), 0.0);
  for (std::size_t i = 0; bulges && i + 1 < rings.size(); ++i) {
    for (int k = 1; k < 8; ++k) {
      const double u = k / 8.0;
      const double z = rings[i].z + u * (rings[i + 1].z - rings[i].z);
      const double sagitta = body.scale(z) - (1 - u) * rings[i].s - u * rings[i + 1].s;
      for (const std::size_t j : {i, i + 1}) extra[j] = std::max(extra[j], sagitta);
    }
  }
  for (std::size_t i = 0; i < rings.size(); ++i) rings[i].s += extra[i];
  return rings;
}

bool whole_cone(const Body& body) {
  const double near = std::min(std::abs(body.z_min), std::abs(body.z_max));
  return body.a == body.b && near < 1e-9;
}

CollisionShape body_shape(const Body& body) {
  if (body.profile == Profile::kEllipse) return round_shape(body);
  if (body.profile == Profile::kConstant && body.a == body.b) return cylinder_shape(body);
  if (body.profile == Profile::kLinear && whole_cone(body)) return cone_shape(body);
  if (body.profile == Profile::kBox) return box_shape(body.X_CQ, body.bounds_Q());
  if (body.profile == Profile::kHyperbola) {
    const double s = std::max(body.scale(body.z_min), body.scale(body.z_max));
    return ring_shape(body, {{body.z_min, s}, {body.z_max, s}});
  }
  return ring_shape(body, enclosing_rings(body));
}

CollisionShape plane_shape(const Detection& d) {
  Eigen::AlignedBox3d box = d.extent_Q;
  const double thickness = std::clamp(0.25 * box.sizes().head<2>().minCoeff(), 0.01, 0.1);
  box.max().z() = 0.0;
  box.min().z() = -thickness;
  return box_shape(d.X_CQ, box);
}

std::vector<CollisionShape> split(const Body& body) {
  if (body.profile != Profile::kHyperbola) return {body_shape(body)};
  constexpr int kPieces = 8;
  std::vector<CollisionShape> pieces;
  for (int i = 0; i < kPieces; ++i) {
    const double step = (body.z_max - body.z_min) / kPieces;
    const double z = body.z_min + i * step;
    // A hyperbola's chords lie outside it.
    pieces.push_back(ring_shape(body, {{z, body.scale(z)}, {z + step, body.scale(z + step)}}));
  }
  return pieces;
}

}  // namespace

std::optional<CollisionShape> make_shape(const Detection& detection, std::string* why) {
  std::optional<CollisionShape> shape;
  if (detection.type == QuadricType::kPlane) {
    const Eigen::Vector3d sides = detection.extent_Q.sizes();
    if (detection.X_CQ.matrix().allFinite() && sides.allFinite() && sides.x() > 0.0 &&
        sides.y() > 0.0) {
      shape = plane_shape(detection);
    } else if (why) {
      *why = "plane has no finite, positive size";
    }
  } else if (const std::optional<Body> body = make_body(detection, why)) {
    shape = body_shape(*body);
  }
  if (shape) {
    shape->target = detection.id;
    shape->geometry->computeLocalAABB();
  }
  return shape;
}

std::vector<CollisionShape> make_pieces(const Body& body) {
  std::vector<CollisionShape> pieces = split(body);
  for (CollisionShape& piece : pieces) piece.geometry->computeLocalAABB();
  return pieces;
}

}  // namespace quadrille

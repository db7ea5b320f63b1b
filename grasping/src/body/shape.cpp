#include "quadrille/grasping/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "body/geometry.hpp"
#include "body/patch.hpp"
#include "body/pieces.hpp"
#include "body/polyhedron.hpp"

namespace quadrille {
namespace {

using Profile = Body::Profile;

// Number of tangents that enclose a bulging profile.
constexpr int kTangents = 8;
// Largest gap between a waist and its chords [m].
constexpr double kMaxSagitta = 0.0002;

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
  } else {
    shape = placed("ellipsoid", body, 0.0);
    shape.dimensions = {body.a, body.b, body.c};
  }
  set_geometry(shape);
  return shape;
}

CollisionShape cylinder_shape(const Body& body) {
  CollisionShape shape = placed("cylinder", body, 0.5 * (body.z_min + body.z_max));
  shape.dimensions = {body.a, body.z_max - body.z_min};
  set_geometry(shape);
  return shape;
}

/// FCL's cone points along +z; ours opens along +z or −z from its apex at the origin.
CollisionShape cone_shape(const Body& body) {
  const double length = body.z_max - body.z_min;
  CollisionShape shape = placed("cone", body, 0.5 * (body.z_min + body.z_max));
  if (body.z_max > 0.0)
    shape.X_CS.rotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
  shape.dimensions = {body.a * length, length};
  set_geometry(shape);
  return shape;
}

/// Computes the rings of a bulging profile from its tangents. Each ring lies where two neighbouring
/// tangents meet, so that all chords lie outside.
/// @return the rings, and the largest gap between their chords and the profile [m]
std::pair<std::vector<Ring>, double> tangent_rings(const Body& body) {
  const bool sheet = body.profile == Profile::kSheet;
  // The profile's parameter t: s = t and z = t², or for a sheet s = sinh t and z = c cosh t.
  const auto parameter = [&](double z) {
    return sheet ? std::acosh(std::max(1.0, z / body.c)) : std::sqrt(std::max(0.0, z));
  };
  const double first = parameter(body.z_min), step = (parameter(body.z_max) - first) / kTangents;
  std::vector<Ring> rings;
  double gap = 0.0;
  if (first > 0.0) rings.push_back({body.z_min, body.scale(body.z_min)});
  for (int i = 0; i < kTangents; ++i) {
    const double t = first + (i + 0.5) * step, h = 0.5 * step;
    const Ring ring = sheet
                          ? Ring{body.c * std::cosh(t) / std::cosh(h), std::sinh(t) / std::cosh(h)}
                          : Ring{t * t - h * h, t};
    const double along = (sheet ? body.c * std::hypot(1.0, ring.s) : ring.s * ring.s) - ring.z;
    const double across = std::max(body.a, body.b) * (ring.s - body.scale(ring.z));
    gap = std::max(gap, std::min(along, across));
    rings.push_back(ring);
  }
  rings.push_back({body.z_max, body.scale(body.z_max)});
  return {rings, gap};
}

/// Makes a polyhedron around a convex body.
CollisionShape polyhedron(const Body& body) {
  const bool bulges = body.profile == Profile::kRoot || body.profile == Profile::kSheet;
  if (!bulges) {
    return make_rings(body,
                      {{body.z_min, body.scale(body.z_min)}, {body.z_max, body.scale(body.z_max)}});
  }
  const auto [rings, gap] = tangent_rings(body);
  CollisionShape shape = make_rings(body, rings);
  shape.excess += gap;
  return shape;
}

/// Makes a stack of frusta around a waist. A hyperbola's chords lie outside it by at most Δz²/8
/// times its largest second derivative, 1/c².
std::vector<CollisionShape> waisted(const Body& body) {
  const double length = body.z_max - body.z_min, waist = std::max(body.a, body.b);
  const double wanted = length / body.c * std::sqrt(waist / (8.0 * kMaxSagitta));
  const int count = static_cast<int>(std::clamp(std::ceil(wanted), 2.0, 16.0));
  const double step = length / count;
  std::vector<CollisionShape> pieces;
  for (int i = 0; i < count; ++i) {
    const double low = body.z_min + i * step, high = i + 1 < count ? low + step : body.z_max;
    pieces.push_back(make_rings(body, {{low, body.scale(low)}, {high, body.scale(high)}}));
    pieces.back().excess += waist * step * step / (8.0 * body.c * body.c);
  }
  return pieces;
}

bool whole_cone(const Body& body) {
  const double near = std::min(std::abs(body.z_min), std::abs(body.z_max));
  return body.a == body.b && near < 1e-9;
}

CollisionShape convex_shape(const Body& body) {
  if (body.profile == Profile::kEllipse) return round_shape(body);
  if (body.profile == Profile::kConstant && body.a == body.b) return cylinder_shape(body);
  if (body.profile == Profile::kLinear && whole_cone(body)) return cone_shape(body);
  if (body.profile == Profile::kBox) return make_box(body.X_CQ, body.bounds_Q());
  return polyhedron(body);
}

}  // namespace

std::vector<CollisionShape> make_shapes(const Detection& detection) {
  const std::optional<Body> body = make_body(detection);
  std::vector<CollisionShape> shapes = body ? make_pieces(*body) : make_patch(detection);
  for (CollisionShape& shape : shapes) {
    shape.target = detection.id;
    shape.X_CS = rounded(shape.X_CS);
  }
  return shapes;
}

CollisionShape make_shape(const Box& box) {
  const Eigen::Vector3d half = 0.5 * box.size;
  const Eigen::AlignedBox3d likely_B(-half, half);
  CollisionShape shape = make_box(box.X_CB, likely_B);
  shape.target = box.id;
  shape.excess = std::max((box.inner_B.min() - likely_B.min()).maxCoeff(),
                          (likely_B.max() - box.inner_B.max()).maxCoeff());
  shape.excess = std::max(shape.excess, 0.0);
  return shape;
}

std::vector<CollisionShape> make_pieces(const Body& body) {
  std::vector<CollisionShape> pieces = body.profile == Profile::kHyperbola
                                           ? waisted(body)
                                           : std::vector<CollisionShape>{convex_shape(body)};
  for (CollisionShape& piece : pieces) piece.excess += body.beyond;
  return pieces;
}

}  // namespace quadrille

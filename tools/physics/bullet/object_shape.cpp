#include "physics/bullet/object_shape.hpp"

#include <cmath>
#include <numbers>

#include "physics/bullet/section_shape.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

// Plates around a wall, and along one that is bent: within 0.2 mm of it at 40 mm of radius.
constexpr int kAround = 32, kBent = 8;
// Frusta of a solid with a waist.
constexpr int kFrusta = 16;

bool is_straight(const TrueBody& body) {
  // s is linear if s² is a square.
  const double D = body.p[1] * body.p[1] - 4.0 * body.p[0] * body.p[2];
  return std::abs(D) < 1e-9 * std::max(body.p.cwiseAbs2().maxCoeff(), 1e-30);
}

bool is_round(const TrueBody& body) { return std::abs(body.a - body.b) < 1e-6 * body.a; }

bool is_cylinder(const TrueBody& body) {
  return is_round(body) &&
         std::abs(body.scale(body.z_min()) - body.scale(body.z_max())) <
             1e-6 * body.scale(body.z_max()) &&
         is_straight(body);
}

std::unique_ptr<btCollisionShape> convex(const TrueBody& body, const Vector3d& centre_S) {
  const Vector3d half = 0.5 * body.box_S.sizes();
  if (body.is_box) return std::make_unique<btBoxShape>(scaled(half));
  if (body.type == "sphere") return std::make_unique<btSphereShape>(kScale * half.z());
  if (is_cylinder(body)) {
    const double radius = body.a * body.scale(body.z_max());
    auto cylinder = std::make_unique<btCylinderShapeZ>(scaled(Vector3d(radius, radius, half.z())));
    cylinder->setMargin(kMargin);
    return cylinder;
  }
  return std::make_unique<SectionShape>(body, body.z_min(), body.z_max(), centre_S);
}

// The frustum between two heights: s is linear between its ends.
TrueBody frustum(const TrueBody& body, double z_0, double z_1) {
  TrueBody part = body;
  const double k = (body.scale(z_1) - body.scale(z_0)) / (z_1 - z_0);
  const double c = body.scale(z_0) - k * z_0;
  part.p = {c * c, 2.0 * c * k, k * k};
  part.box_S.min().z() = z_0;
  part.box_S.max().z() = z_1;
  return part;
}

void add(ObjectShape* shape, std::unique_ptr<btCollisionShape> part) {
  shape->compound->addChildShape(btTransform::getIdentity(), part.get());
  shape->parts.push_back(std::move(part));
}

void add_frusta(const TrueBody& body, const Vector3d& centre_S, ObjectShape* shape) {
  const double step = (body.z_max() - body.z_min()) / kFrusta;
  for (int i = 0; i < kFrusta; ++i) {
    const double z_0 = body.z_min() + i * step, z_1 = z_0 + step;
    add(shape, std::make_unique<SectionShape>(frustum(body, z_0, z_1), z_0, z_1, centre_S));
  }
}

// One plate: what lies within half the wall of the surface between two angles and two heights.
std::unique_ptr<btCollisionShape> plate(const TrueBody& body, const Vector3d& centre_S,
                                        const std::array<double, 2>& angles,
                                        const std::array<double, 2>& heights) {
  auto hull = std::make_unique<btConvexHullShape>();
  hull->setMargin(0.0);
  for (const double angle : angles) {
    for (const double z : heights) {
      const Vector3d p = body.point_S(angle, z) - centre_S, n = body.normal_S(angle, z);
      hull->addPoint(scaled(Vector3d(p + 0.5 * body.wall * n)), false);
      hull->addPoint(scaled(Vector3d(p - 0.5 * body.wall * n)), false);
    }
  }
  hull->recalcLocalAabb();
  return hull;
}

void add_wall(const TrueBody& body, const Vector3d& centre_S, ObjectShape* shape) {
  const int rows = is_straight(body) ? 1 : kBent;
  const double step = (body.z_max() - body.z_min()) / rows, turn = 2.0 * std::numbers::pi / kAround;
  for (int row = 0; row < rows; ++row) {
    const double z = body.z_min() + row * step;
    for (int k = 0; k < kAround; ++k) {
      add(shape, plate(body, centre_S, {k * turn, (k + 1) * turn}, {z, z + step}));
    }
  }
  const double z_0 = body.z_min(), z_1 = body.z_max();
  const auto floor = [&](double from, double to) {
    add(shape, std::make_unique<SectionShape>(frustum(body, from, to), from, to, centre_S));
  };
  if (!body.open_low && body.scale(z_0) > 0.0) floor(z_0, z_0 + body.wall);
  if (!body.open_high && body.scale(z_1) > 0.0) floor(z_1 - body.wall, z_1);
}

}  // namespace

ObjectShape make_object_shape(const TrueBody& body, const Vector3d& centre_S) {
  ObjectShape shape;
  if (body.wall == 0.0 && body.is_convex()) {
    shape.parts.push_back(convex(body, centre_S));
    return shape;
  }
  shape.compound = std::make_unique<btCompoundShape>();
  if (body.wall > 0.0) {
    add_wall(body, centre_S, &shape);
  } else {
    add_frusta(body, centre_S, &shape);
  }
  return shape;
}

}  // namespace quadrille::physics

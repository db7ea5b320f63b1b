#include "lab/physics/bullet/object_shape.hpp"

#include <cmath>

#include "lab/physics/bullet/section_shape.hpp"
#include "lab/physics/bullet/wall_shape.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

// Number of frusta that make up a solid with a waist.
constexpr int kFrusta = 16;

bool is_straight(const TrueBody& body) {
  // The scale s is linear if s² is the square of a linear function.
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

// Returns the frustum between two heights, in which s is linear.
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

}  // namespace

ObjectShape make_object_shape(const TrueBody& body, const Vector3d& centre_S) {
  ObjectShape shape;
  if (body.wall == 0.0 && body.is_convex()) {
    shape.parts.push_back(convex(body, centre_S));
    return shape;
  }
  if (body.wall > 0.0) {
    shape.parts.push_back(std::make_unique<WallShape>(body, centre_S));
    return shape;
  }
  shape.compound = std::make_unique<btCompoundShape>();
  add_frusta(body, centre_S, &shape);
  return shape;
}

}  // namespace quadrille::physics

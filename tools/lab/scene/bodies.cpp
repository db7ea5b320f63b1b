#include "lab/scene/bodies.hpp"

#include <algorithm>
#include <array>

namespace quadrille::scene {
namespace {

using Box = Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Returns the quadric m.(x²) + 2 g_z z + j in the surface's own frame.
Quadric axis_quadric(const Vector3d& m, double g_z, double j) {
  Vector10d q = Vector10d::Zero();
  q.head<3>() = m;
  q[8] = g_z;
  q[9] = j;
  return Quadric(q);
}

Box box_of(double half_x, double half_y, double low, double high) {
  return Box(Vector3d(-half_x, -half_y, low), Vector3d(half_x, half_y, high));
}

Isometry3d shifted(const Vector3d& p) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = p;
  return X;
}

/// Returns an exact quarter turn that lays z along y and x up.
Isometry3d lying(double lift) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  X.translation() = Vector3d(0, 0, lift);
  return X;
}

void add(Body* body, Surface surface, const Isometry3d& X_BS) {
  body->surfaces.push_back(std::move(surface));
  body->X_BS.push_back(X_BS);
}

/// Adds a flat lid at local height z of a quadric's interior.
void add_cap(Body* body, double z, const Isometry3d& X_BS) {
  const Surface& side = body->surfaces.front();
  Surface cap{"cap", false, axis_quadric(Vector3d::Zero(), 0.5, -z), side.box_S, side.Q_S, {}};
  cap.box_S.min().z() = cap.box_S.max().z() = z;
  add(body, std::move(cap), X_BS);
}

Body ball(double a, double b, double c) {
  const bool round = a == b && b == c;
  const Vector3d axes(a, b, c);
  Surface side{round ? "sphere" : "ellipsoid",
               true,
               axis_quadric(axes.cwiseAbs2().cwiseInverse(), 0, -1),
               Box(-axes, axes),
               {},
               {}};
  if (round) {
    side.dims = {{"radius", a}};
  } else {
    side.dims = {{"a", a}, {"b", b}, {"c", c}};
  }
  Body body{side.type, {}, {}, Isometry3d::Identity(), std::max(a, b)};
  add(&body, side, shifted({0, 0, c}));
  return body;
}

Body tin(double a, double b, double length, bool upright) {
  const bool round = a == b;
  Surface side{round ? "cylinder" : "elliptic_cylinder",
               true,
               axis_quadric({1 / (a * a), 1 / (b * b), 0}, 0, -1),
               box_of(a, b, -length / 2, length / 2),
               {},
               {}};
  side.dims = {{"a", a}, {"b", b}, {"length", length}};
  if (round) side.dims = {{"radius", a}, {"length", length}};
  Body body{side.type, {}, {}, Isometry3d::Identity(), 0.0};
  const Isometry3d X_BS = upright ? shifted({0, 0, length / 2}) : lying(a);
  add(&body, side, X_BS);
  add_cap(&body, -length / 2, X_BS);
  add_cap(&body, length / 2, X_BS);
  body.reach = upright ? std::max(a, b) : std::sqrt(b * b + length * length / 4);
  return body;
}

/// Makes a cone whose radius grows by `slope` per metre from the apex, cut to [low, high] from it.
/// It stands on its wide end, or as an open cup on its narrow end.
Body cone(double slope, double low, double high, bool cup) {
  const double radius = slope * high;
  Surface side{
      "cone", true, axis_quadric({1, 1, -slope * slope}, 0, 0), box_of(radius, radius, low, high),
      {},     {}};
  side.dims = {{"slope", slope},
               {"radius_low", slope * low},
               {"radius_high", radius},
               {"length", high - low}};
  Body body{side.type, {}, {}, Isometry3d::Identity(), radius};
  Isometry3d X_BS = shifted({0, 0, -low});
  if (!cup) {
    X_BS.linear().diagonal() << 1, -1, -1;
    X_BS.translation().z() = high;
  }
  add(&body, side, X_BS);
  if (!cup) add_cap(&body, high, X_BS);
  if (low > 0.0) add_cap(&body, low, X_BS);
  return body;
}

/// Makes z = x²/4fa + y²/4fb up to a height, as an open bowl or, upside down, as a dome.
Body paraboloid(double focal_a, double focal_b, double height, bool bowl) {
  const double half_x = 2 * std::sqrt(focal_a * height), half_y = 2 * std::sqrt(focal_b * height);
  Surface side{"elliptic_paraboloid",
               true,
               axis_quadric({1 / (4 * focal_a), 1 / (4 * focal_b), 0}, -0.5, 0),
               box_of(half_x, half_y, 0, height),
               {},
               {}};
  side.dims = {{"focal_a", focal_a}, {"focal_b", focal_b}, {"height", height}};
  Body body{side.type, {}, {}, Isometry3d::Identity(), std::max(half_x, half_y)};
  Isometry3d X_BS = Isometry3d::Identity();
  if (!bowl) {
    X_BS.linear().diagonal() << 1, -1, -1;
    X_BS.translation().z() = height;
  }
  add(&body, side, X_BS);
  return body;
}

/// Makes x²/a² + y²/a² - z²/c² = 1 between two heights about its waist, open at the top.
Body vase(double a, double c, double below, double above) {
  const double most = std::max(below, above);
  const double radius = a * std::sqrt(1 + most * most / (c * c));
  Surface side{"hyperboloid_one_sheet",
               true,
               axis_quadric({1 / (a * a), 1 / (a * a), -1 / (c * c)}, 0, -1),
               box_of(radius, radius, -below, above),
               {},
               {}};
  side.dims = {{"a", a}, {"b", a}, {"c", c}, {"length", below + above}};
  Body body{side.type, {}, {}, Isometry3d::Identity(), radius};
  const Isometry3d X_BS = shifted({0, 0, below});
  add(&body, side, X_BS);
  add_cap(&body, -below, X_BS);
  return body;
}

Body random_cone(double s, Random* random) {
  const double radius = s * random->uniform(0.045, 0.08), height = s * random->uniform(0.09, 0.2);
  if (random->chance(0.35)) return cone(radius / height, 0, height, false);
  // The random share of the full cone is cut off at its tip.
  const double high = height / (1 - random->uniform(0.3, 0.6));
  return cone(radius / high, high - height, high, random->chance(0.5));
}

Body random_paraboloid(double s, Random* random) {
  const double height = s * random->uniform(0.05, 0.1), radius = s * random->uniform(0.06, 0.11);
  const double focal = radius * radius / (4 * height);
  const double oval = random->chance(0.5) ? 1.0 : random->uniform(1.2, 1.5);
  return paraboloid(focal, focal / oval, height, random->chance(0.5));
}

Surface rectangle(const std::string& type, double half_x, double half_y) {
  return {type,
          false,
          axis_quadric(Vector3d::Zero(), 0.5, 0),
          box_of(half_x, half_y, 0, 0),
          {},
          {{"width", 2 * half_x}, {"height", 2 * half_y}}};
}

}  // namespace

Body random_quadric(double scale, Random* random) {
  const double s = scale;
  switch (random->integer(0, 6)) {
    case 0: {
      const double radius = s * random->uniform(0.035, 0.1);
      return ball(radius, radius, radius);
    }
    case 1: {
      const double b = s * random->uniform(0.035, 0.08);
      return ball(b * random->uniform(1.25, 1.6), b, b * random->uniform(0.6, 0.8));
    }
    case 2: {
      const double radius = s * random->uniform(0.03, 0.07);
      return tin(radius, radius, s * random->uniform(0.08, 0.22), random->chance(0.7));
    }
    case 3: {
      const double a = s * random->uniform(0.03, 0.05);
      return tin(a, a * random->uniform(1.35, 1.9), s * random->uniform(0.08, 0.2),
                 random->chance(0.7));
    }
    case 4:
      return random_cone(s, random);
    case 5:
      return random_paraboloid(s, random);
    default: {
      const double a = s * random->uniform(0.03, 0.055), c = a * random->uniform(1.2, 2.0);
      return vase(a, c, s * random->uniform(0.05, 0.08), s * random->uniform(0.06, 0.12));
    }
  }
}

Body random_box(double scale, Random* random) {
  return make_box(scale * Vector3d(random->uniform(0.03, 0.09), random->uniform(0.03, 0.07),
                                   random->uniform(0.02, 0.08)));
}

Body make_box(const Vector3d& half) {
  Body body{"box", {}, {}, Isometry3d::Identity(), half.head<2>().norm()};
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const double side : {-1.0, 1.0}) {
      Isometry3d X = shifted(Vector3d(0, 0, half.z()) + side * half[axis] * Vector3d::Unit(axis));
      X.linear() << Vector3d::Unit(u), Vector3d::Unit(v), Vector3d::Unit(axis);
      add(&body, rectangle("face", half[u], half[v]), X);
    }
  }
  return body;
}

Body make_cylinder(double radius, double length) { return tin(radius, radius, length, true); }

Body make_ball(const Vector3d& axes) { return ball(axes.x(), axes.y(), axes.z()); }

Body make_tray(double half_x, double half_y, double height) {
  Body body{"tray", {}, {}, Isometry3d::Identity(), std::sqrt(half_x * half_x + half_y * half_y)};
  for (const double side : {-1.0, 1.0}) {
    Isometry3d X = shifted({side * half_x, 0, height / 2});
    X.linear() << Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX();
    add(&body, rectangle("face", half_y, height / 2), X);
    X = shifted({0, side * half_y, height / 2});
    X.linear() << Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY();
    add(&body, rectangle("face", height / 2, half_x), X);
  }
  return body;
}

Body make_table(double half_x, double half_y) {
  Body body{"table", {}, {}, Isometry3d::Identity(), 0.0};
  add(&body, rectangle("table", half_x, half_y), Isometry3d::Identity());
  return body;
}

Body make_wall() {
  Body body{"wall", {}, {}, Isometry3d::Identity(), 0.0};
  add(&body, rectangle("wall", 1.5, 2.5), lying(1.5));
  return body;
}

}  // namespace quadrille::scene

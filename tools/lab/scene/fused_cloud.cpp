#include "lab/scene/fused_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace quadrille::scene {
namespace {

using Eigen::Vector3d;

constexpr double kNoise = 0.0012, kTableShare = 0.55, kPitch = 0.3;
constexpr double kPointsPerThing = 350000.0 / 12.0;
constexpr int kExactPoints = 60;

/// A point of a surface with its unit normal.
struct SurfacePoint {
  Vector3d x, n;
};

/// A surface of revolution that stands upright on the table.
struct Standing {
  QuadricType type = QuadricType::kSphere;
  /// Position of the foot, radius at the foot (or of the sphere), and height [m].
  Vector3d foot = Vector3d::Zero();
  double radius = 0.0, height = 0.0;

  /// Draws a point that is uniformly distributed over the surface.
  SurfacePoint draw(Random* random) const;
};

SurfacePoint Standing::draw(Random* random) const {
  Vector3d around = Vector3d::Zero();
  around.head<2>() = random->direction();
  if (type == QuadricType::kSphere) {
    // By Archimedes' theorem, heights are uniform on a sphere.
    const double sine = random->uniform(-1.0, 1.0);
    const Vector3d n = std::sqrt(1.0 - sine * sine) * around + sine * Vector3d::UnitZ();
    return {foot + radius * (Vector3d::UnitZ() + n), n};
  }
  if (type == QuadricType::kCylinder) {
    return {foot + radius * around + random->uniform(0.0, height) * Vector3d::UnitZ(), around};
  }
  // On a cone, the area grows with the square of the distance from the apex.
  const double share = std::sqrt(random->uniform());
  const Vector3d n = (height * around + radius * Vector3d::UnitZ()).normalized();
  return {foot + share * radius * around + (1.0 - share) * height * Vector3d::UnitZ(), n};
}

Standing draw_thing(int number, int columns, Random* random) {
  Standing thing;
  thing.foot = {kPitch * (number % columns), kPitch * (number / columns), 0.0};
  thing.radius = random->uniform(0.035, 0.06);
  thing.height = random->uniform(0.09, 0.14);
  constexpr QuadricType kTypes[] = {QuadricType::kSphere, QuadricType::kCylinder,
                                    QuadricType::kCone};
  thing.type = kTypes[number % 3];
  return thing;
}

}  // namespace

FusedCloud make_fused_cloud(int points, Random* random) {
  const int things = std::max(12, static_cast<int>(points / kPointsPerThing));
  const int columns = static_cast<int>(std::ceil(std::sqrt(4.0 / 3.0 * things)));
  const int rows = (things + columns - 1) / columns;
  FusedCloud fused;
  std::vector<Standing> standing;
  for (int i = 0; i < things; ++i) {
    standing.push_back(draw_thing(i, columns, random));
    FusedThing thing{standing.back().type, {}};
    for (int k = 0; k < kExactPoints; ++k) {
      thing.exact_C.push_back(standing.back().draw(random).x);
    }
    fused.things.push_back(std::move(thing));
  }
  fused.cloud.viewpoint = {0.5 * kPitch * columns, 0.5 * kPitch * rows, 1.5};
  fused.cloud.read = static_cast<std::size_t>(points);
  fused.cloud.points.reserve(fused.cloud.read);
  for (int i = 0; i < points; ++i) {
    const SurfacePoint p =
        random->chance(kTableShare)
            ? SurfacePoint{{random->uniform(-kPitch, kPitch * columns),
                            random->uniform(-kPitch, kPitch * rows), 0.0},
                           Vector3d::UnitZ()}
            : standing[static_cast<std::size_t>(random->below(things))].draw(random);
    fused.cloud.points.push_back((p.x + kNoise * random->normal() * p.n).cast<float>());
  }
  return fused;
}

}  // namespace quadrille::scene

#include "contacts/surface_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/lanes.hpp"

namespace quadrille {
namespace {

constexpr std::size_t kHeights = SurfaceGrid::kHeights, kAngles = SurfaceGrid::kAngles;
constexpr std::size_t kPoints = SurfaceGrid::kPoints;
static_assert(kPoints % kDoubleLanes == 0);

QUADRILLE_INTO_CLONES void lower_to(const DoubleLanes& others, DoubleLanes& values) {
  values = others < values ? others : values;
}
QUADRILLE_INTO_CLONES void raise_to(const DoubleLanes& others, DoubleLanes& values) {
  values = others > values ? others : values;
}

QUADRILLE_INTO_CLONES double least_of(const DoubleLanes& lanes) {
  return std::min(std::min(lanes[0], lanes[1]), std::min(lanes[2], lanes[3]));
}
QUADRILLE_INTO_CLONES double greatest_of(const DoubleLanes& lanes) {
  return std::max(std::max(lanes[0], lanes[1]), std::max(lanes[2], lanes[3]));
}

}  // namespace

SurfaceGrid surface_grid(const Body& body) {
  SurfaceGrid points;
  for (std::size_t i = 0; i < kHeights; ++i) {
    // Points lie denser towards the ends, where a profile may close quickly.
    const double u =
        0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i) / (kHeights - 1));
    const double z = (1.0 - u) * body.z_min + u * body.z_max, s = body.scale(z);
    for (std::size_t k = 0; k < kAngles; ++k) {
      const double t = 2.0 * std::numbers::pi * static_cast<double>(k) / kAngles;
      const Eigen::Vector3d p_C =
          body.X_CQ * Eigen::Vector3d(body.a * s * std::cos(t), body.b * s * std::sin(t), z);
      const std::size_t n = i * kAngles + k;
      points.x[n] = p_C.x(), points.y[n] = p_C.y(), points.z[n] = p_C.z();
    }
  }
  return points;
}

QUADRILLE_VECTOR_CLONES
void turn_points(const SurfaceGrid& points_C, const Eigen::Matrix3d& R_CG, SurfaceGrid* points_G) {
  const double *x = points_C.x.data(), *y = points_C.y.data(), *z = points_C.z.data();
  double *__restrict x_G = points_G->x.data(), *__restrict y_G = points_G->y.data(),
                     *__restrict z_G = points_G->z.data();
  const double xx = R_CG(0, 0), yx = R_CG(1, 0), zx = R_CG(2, 0);
  const double xy = R_CG(0, 1), yy = R_CG(1, 1), zy = R_CG(2, 1);
  const double xz = R_CG(0, 2), yz = R_CG(1, 2), zz = R_CG(2, 2);
  for (std::size_t n = 0; n < kPoints; ++n) {
    x_G[n] = x[n] * xx + y[n] * yx + z[n] * zx;
    y_G[n] = x[n] * xy + y[n] * yy + z[n] * zy;
    z_G[n] = x[n] * xz + y[n] * yz + z[n] * zz;
  }
}

QUADRILLE_VECTOR_CLONES
GridBounds bounds_within(const SurfaceGrid& points, double deep, double nearest) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const DoubleLanes low = DoubleLanes{} - kFar, high = DoubleLanes{} + kFar;
  DoubleLanes x_min = high, y_min = high, x_max = low, y_max = low;
  for (std::size_t n = 0; n < kPoints; n += kDoubleLanes) {
    DoubleLanes x, y, z;
    load(points.x.data() + n, x), load(points.y.data() + n, y), load(points.z.data() + n, z);
    const DoubleMasks in = z - nearest <= deep;
    lower_to(in ? x : high, x_min), raise_to(in ? x : low, x_max);
    lower_to(in ? y : high, y_min), raise_to(in ? y : low, y_max);
  }
  return {least_of(x_min), greatest_of(x_max), least_of(y_min), greatest_of(y_max)};
}

QUADRILLE_VECTOR_CLONES
GridSpan span_of(const std::array<double, SurfaceGrid::kPoints>& values) {
  DoubleLanes low, high;
  load(values.data(), low);
  high = low;
  for (std::size_t n = kDoubleLanes; n < kPoints; n += kDoubleLanes) {
    DoubleLanes lanes;
    load(values.data() + n, lanes);
    lower_to(lanes, low), raise_to(lanes, high);
  }
  return {least_of(low), greatest_of(high)};
}

}  // namespace quadrille

#include "contacts/surface_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

using GridValues = std::array<double, SurfaceGrid::kPoints>;

Body upright_cylinder() {
  Body body;
  body.profile = Body::Profile::kConstant;
  body.a = 0.04, body.b = 0.03;
  body.z_min = -0.05, body.z_max = 0.07;
  body.X_CQ = Eigen::Translation3d(0.1, -0.2, 0.8) *
              Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized());
  return body;
}

}  // namespace

TEST_CASE("the points of a grid lie on the surface, up to both of its ends", "[contacts]") {
  const Body body = upright_cylinder();
  const SurfaceGrid grid = surface_grid(body);
  double low = INFINITY, high = -INFINITY;
  for (std::size_t n = 0; n < SurfaceGrid::kPoints; ++n) {
    const Eigen::Vector3d p_Q =
        body.X_CQ.inverse() * Eigen::Vector3d(grid.x[n], grid.y[n], grid.z[n]);
    CHECK(std::hypot(p_Q.x() / body.a, p_Q.y() / body.b) == Approx(1.0));
    low = std::min(low, p_Q.z()), high = std::max(high, p_Q.z());
  }
  CHECK(low == Approx(body.z_min));
  CHECK(high == Approx(body.z_max));
}

TEST_CASE("turned points, their spans and bounds are those of plain loops", "[contacts]") {
  const SurfaceGrid grid_C = surface_grid(upright_cylinder());
  SurfaceGrid grid_G = grid_C;
  RandomStream random(8, 0);
  for (int k = 0; k < 50; ++k) {
    const double w = random.uniform(), x = random.uniform(), y = random.uniform();
    const Eigen::Matrix3d R_CG = Eigen::Quaterniond(w, x, y, 0.3).normalized().toRotationMatrix();
    turn_points(grid_C, R_CG, &grid_G);
    double nearest = INFINITY;
    for (std::size_t n = 0; n < SurfaceGrid::kPoints; ++n) {
      const Eigen::Vector3d p_G =
          R_CG.transpose() * Eigen::Vector3d(grid_C.x[n], grid_C.y[n], grid_C.z[n]);
      CHECK((p_G - Eigen::Vector3d(grid_G.x[n], grid_G.y[n], grid_G.z[n])).norm() < 1e-12);
      nearest = std::min(nearest, grid_G.z[n]);
    }
    for (const GridValues* values : {&grid_G.x, &grid_G.y, &grid_G.z}) {
      CHECK(span_of(*values).least == *std::min_element(values->begin(), values->end()));
      CHECK(span_of(*values).greatest == *std::max_element(values->begin(), values->end()));
    }
    const double deep = 0.02 * random.uniform();
    GridBounds expected{INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (std::size_t n = 0; n < SurfaceGrid::kPoints; ++n) {
      if (grid_G.z[n] - nearest > deep) continue;
      expected.x_min = std::min(expected.x_min, grid_G.x[n]);
      expected.x_max = std::max(expected.x_max, grid_G.x[n]);
      expected.y_min = std::min(expected.y_min, grid_G.y[n]);
      expected.y_max = std::max(expected.y_max, grid_G.y[n]);
    }
    const GridBounds bounds = bounds_within(grid_G, deep, nearest);
    CHECK(bounds.x_min == expected.x_min);
    CHECK(bounds.x_max == expected.x_max);
    CHECK(bounds.y_min == expected.y_min);
    CHECK(bounds.y_max == expected.y_max);
  }
}

#include "fit/half_gradient.hpp"

#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("half gradients and values are those of the quadric", "[half_gradient]") {
  RandomStream random(95, 0);
  for (const FamilyExample& example : family_examples()) {
    // Below, at and above whole vectors of points.
    for (const int count : {1, 8, 29}) {
      CAPTURE(example.name, count);
      std::vector<OrientedPoint> points = points_on(example.D, count, example.low, random);
      for (OrientedPoint& p : points) p.x += 0.1 * gaussian(random) * p.n;
      const Quadric Q(example.D);
      const HalfGradients many(to_fit_points(points), Q.matrix());
      const Coefficients<double> q(Q.matrix());
      for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d& x = points[i].x;
        const HalfGradient<double> one = half_gradient(q, x.x(), x.y(), x.z());
        CHECK((2.0 * Eigen::Vector3d(one.x, one.y, one.z) - Q.gradient(x)).norm() < 1e-12);
        CHECK(std::abs(one.f - Q.value(x)) < 1e-12);
        CHECK((Eigen::Vector3d(many.x()[i], many.y()[i], many.z()[i]) -
               Eigen::Vector3d(one.x, one.y, one.z))
                  .norm() < 1e-5);
        CHECK(std::abs(many.f()[i] - one.f) < 1e-5);
      }
    }
  }
}

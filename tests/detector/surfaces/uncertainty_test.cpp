#include "surfaces/uncertainty.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "fit/geometric_fit.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/evidence/evidence.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A surface of all samples with the fit of a family, in units of the surface.
Surface fitted(const SurfaceSamples& samples, Family family, const Quadric& start) {
  Surface surface;
  surface.region = all_of(samples);
  surface.local = normalisation_of(samples, surface.region);
  const OrientedPointsf points = fit_points(samples, surface.region, surface.local, 240);
  PosedQuadric at;
  at.X.translation() = -surface.local.centre / surface.local.scale;
  at.D = start.matrix();
  at.D.topLeftCorner<3, 3>() *= surface.local.scale * surface.local.scale;
  at.D /= -at.D(3, 3);
  surface.fit = refine(points, family, at, 20).value();
  surface.information = information(points, surface.fit);
  surface.Q = surface.local.to_frame(surface.fit.posed.matrix()).normalized();
  surface.evidence = collect_evidence(samples, surface.region, surface.Q);
  return surface;
}

Quadric sphere(double radius) {
  return Quadric(Eigen::Vector4d(1, 1, 1, -radius * radius).asDiagonal().toDenseMatrix());
}

}  // namespace

TEST_CASE("the covariance of q is that of the fits of many noisy samples", "[uncertainty][law]") {
  constexpr double kRadius = 0.04, kNoise = 0.001;
  constexpr int kDraws = 300;
  const Vector10d truth = sphere(kRadius).normalized().coefficients();
  Eigen::Matrix<double, 10, 10> drawn = Eigen::Matrix<double, 10, 10>::Zero(), published = drawn;
  for (std::uint64_t k = 0; k < kDraws; ++k) {
    const SurfaceSamples samples = sphere_grid(15, 15, kRadius, 0.004, kNoise, k);
    const Surface surface = fitted(samples, Family::kSphere, sphere(kRadius));
    const Uncertainty u = uncertainty_of(surface, samples, canonical_form(surface.fit.posed));
    Vector10d q = surface.Q.coefficients();
    if (q.dot(truth) < 0) q = -q;
    drawn += (q - truth) * (q - truth).transpose() / kDraws;
    published += u.covariance.known / kDraws;
    REQUIRE(u.covariance.open.cols() == 0);
    // A unit vector only turns.
    CHECK(std::abs(q.dot(u.covariance.known * q)) < 1e-6 * u.covariance.known.trace());
  }
  // In each direction that is drawn at all: the published one is meant for noise as sensors have
  // it, 1.2 times the deviation of independent noise, and a few draws have correlated noise by
  // chance.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 10, 10>> eigen(drawn);
  for (int i = 6; i < 10; ++i) {
    const Vector10d v = eigen.eigenvectors().col(i);
    const double ratio = std::sqrt(v.dot(published * v) / eigen.eigenvalues()[i]);
    CAPTURE(i, ratio);
    CHECK(ratio > 0.9);
    CHECK(ratio < 1.7);
  }
  CHECK(published.trace() < 3.0 * drawn.trace());
}

TEST_CASE("a cap that shows how it bends but not how deep it goes leaves a semi-axis open",
          "[uncertainty]") {
  // A patch of 24 by 24 mm of a ball of radius 80 mm, seen along x: as an ellipsoid, its depth
  // along x is anybody's guess.
  const SurfaceSamples samples = sphere_grid(9, 9, 0.08, 0.003, 0.0005, 7);
  Surface surface = fitted(samples, Family::kSphere, sphere(0.08));
  // The same surface, taken for a spheroid.
  surface.fit.family = Family::kRevolution;
  surface.fit.posed.D.diagonal() << 1.02, 1.02, 1.0,
      surface.fit.posed.D(3, 3) / surface.fit.posed.D(0, 0);
  const CanonicalForm form = canonical_form(surface.fit.posed);
  REQUIRE(form.type == QuadricType::kEllipsoid);
  const Uncertainty u = uncertainty_of(surface, samples, form);
  REQUIRE(u.std.size() == 3);
  CHECK(std::count_if(u.std.begin(), u.std.end(), [](double s) { return std::isinf(s); }) >= 1);
  REQUIRE(u.covariance.open.cols() >= 1);
  const Eigen::MatrixXd product = u.covariance.open.transpose() * u.covariance.open;
  CHECK(product.isIdentity(1e-9));
}

TEST_CASE("noise that neighbours share makes a radius less certain, noise of their own does not",
          "[uncertainty]") {
  const SurfaceSamples own = sphere_grid(20, 20, 0.04, 0.004, 0.001, 3);
  SurfaceSamples shared = own;
  // Waves as long as a third of the patch, as large as the noise was.
  for (int i = 0; i < shared.size(); ++i) {
    const Eigen::Vector3f x = shared.p[i];
    shared.raw[i] = x + 0.0014f * std::sin(250.0f * x.y()) * shared.n[i];
  }
  const auto std_of = [](const SurfaceSamples& samples) {
    const Surface surface = fitted(samples, Family::kSphere, sphere(0.04));
    return surface.local.scale *
           uncertainty_of(surface, samples, canonical_form(surface.fit.posed)).std.front();
  };
  CHECK(std_of(shared) > 3.0 * std_of(own));
}

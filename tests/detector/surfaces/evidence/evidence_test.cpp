#include "surfaces/evidence/evidence.hpp"

#include <cmath>

#include "detector/pipe.hpp"
#include "samples/region.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

Quadric cylinder_quadric() { return Quadric(diagonal(1, 1, 0, -kPipeRadius * kPipeRadius)); }

/// Two planes that meet at a right angle along z in the middle column.
SurfaceSamples edge_grid() {
  return surface_grid(
      30, 30,
      [](int i, int j) {
        const double s = (i - 14.5) * 0.004, z = j * 0.004;
        return s < 0 ? OrientedPoint{{0, s, z}, -Eigen::Vector3d::UnitX()}
                     : OrientedPoint{{s, 0, z}, -Eigen::Vector3d::UnitY()};
      },
      0.004, 0.0005, 1);
}

}  // namespace

TEST_CASE("count and spread are those of the closed form", "[evidence]") {
  // Normals fill angles up to ±a evenly: the 90th percentile is 0.9 a.
  const SurfaceSamples samples = cylinder_grid(21, 31, kPipeRadius, 0.004, 0.0005, 1);
  const Evidence e = collect_evidence(samples, all_of(samples), cylinder_quadric());
  CHECK(e.log_count == Approx(std::log(21.0 * 31.0)));
  CHECK(e.spread == Approx(0.9 * 10 * 0.004 / kPipeRadius).epsilon(0.03));
}

TEST_CASE("a whole surface has no smooth border, a piece cut out of one has", "[evidence]") {
  const SurfaceSamples samples = cylinder_grid(25, 40, kPipeRadius, 0.004, 0.0005, 2);
  std::vector<int> lower;
  for (const int i : all_of(samples)) {
    if (i / 25 < 20) lower.push_back(i);
  }
  CHECK(collect_evidence(samples, all_of(samples), cylinder_quadric()).smooth_border == 0.0);
  CHECK(collect_evidence(samples, lower, cylinder_quadric()).smooth_border > 0.15);
}

TEST_CASE("a smooth border at which another surface begins speaks against none", "[evidence]") {
  const SurfaceSamples samples = cylinder_grid(25, 40, kPipeRadius, 0.004, 0.0005, 2);
  std::vector<int> middle;
  Mask free(samples.p.size(), 1);
  for (const int i : all_of(samples)) {
    const int row = i / 25;
    if (row >= 10 && row < 30) middle.push_back(i);
    free[i] = row < 30;
  }
  const Quadric Q = cylinder_quadric();
  const double alone = collect_evidence(samples, middle, Q).smooth_border;
  CHECK(alone > 0.3);
  CHECK(collect_evidence(samples, middle, Q, free).smooth_border ==
        Approx(0.5 * alone).epsilon(0.05));
}

TEST_CASE("border, edge and thickness are those of the closed form", "[evidence]") {
  const SurfaceSamples samples = cylinder_grid(21, 30, kPipeRadius, 0.004, 0.0, 1);
  const Evidence whole = collect_evidence(samples, all_of(samples), cylinder_quadric());
  CHECK(whole.open_border == 0.0);
  CHECK(whole.depth_edge == Approx(1.0 - 19.0 * 28.0 / (21.0 * 30.0)));
  CHECK(whole.interior == Approx(19.0 * 28.0 / (21.0 * 30.0)));
  // Cut off at row 20: one row of 21 has neighbours outside.
  std::vector<int> lower;
  for (const int i : all_of(samples)) {
    if (i / 21 < 20) lower.push_back(i);
  }
  CHECK(collect_evidence(samples, lower, cylinder_quadric()).open_border == Approx(1.0 / 20.0));
  // Angles fill ±1 evenly: R cos a is the depth, and the length is along.
  const double a = 10 * 0.004 / kPipeRadius, c = std::sin(a) / a;
  const double across = kPipeRadius * std::sqrt(0.5 + 0.25 * std::sin(2 * a) / a - c * c);
  const double along = 30 * 0.004 / std::sqrt(12.0);
  CHECK(whole.thickness == Approx(across / along).epsilon(0.1));
}

TEST_CASE("two planes explain a box edge, but not a cylinder", "[evidence]") {
  const SurfaceSamples round = cylinder_grid(25, 40, kPipeRadius, 0.004, 0.0005, 3);
  const Evidence cylinder = collect_evidence(round, all_of(round), cylinder_quadric());
  CHECK(cylinder.two_planes > 1.5);
  // The pair of planes itself, xy = 0, is the best quadric of the edge.
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  D(0, 1) = D(1, 0) = 1.0;
  const SurfaceSamples edge = edge_grid();
  const Evidence planes = collect_evidence(edge, all_of(edge), Quadric(D));
  CHECK(std::abs(planes.two_planes) < 0.3);
}

TEST_CASE("residual, roughness and correlation tell white noise from a wrong shape", "[evidence]") {
  const double noise = 0.001;
  const SurfaceSamples samples = cylinder_grid(25, 60, kPipeRadius, 0.004, noise, 7);
  const Evidence right = collect_evidence(samples, all_of(samples), cylinder_quadric());
  CHECK(right.sigma == Approx(noise));
  CHECK(right.residual == Approx(1.0).epsilon(0.1));
  CHECK(right.roughness == Approx(1.0).epsilon(0.1));
  CHECK(std::abs(right.correlation) < 0.1);
  // Too wide by four sigma, which all distances have in common: to first order f / |∇f| is
  // (R² − r²) / 2R at the distance R from the axis, and grows by (1 + r²/R²) / 2 of R's changes.
  const double R = kPipeRadius, r = R + 4 * noise, offset = (R * R - r * r) / (2 * R) / noise;
  const Evidence wide =
      collect_evidence(samples, all_of(samples), Quadric(diagonal(1, 1, 0, -r * r)));
  const double growth = 0.5 * (1 + r * r / (R * R));
  CHECK(wide.residual == Approx(std::hypot(growth * right.residual, offset)).epsilon(0.02));
  CHECK(wide.roughness == Approx(growth * right.roughness).epsilon(0.02));
  CHECK(wide.correlation ==
        Approx(offset * offset / (offset * offset + growth * growth)).epsilon(0.03));
}

TEST_CASE("a single plane explains a cylinder by the depth of its arc", "[evidence]") {
  const SurfaceSamples samples = cylinder_grid(21, 31, kPipeRadius, 0.004, 0.001, 5);
  const Evidence e = collect_evidence(samples, all_of(samples), cylinder_quadric());
  // The arc fills angles up to ±a: the variance of R cos over them.
  const double a = 10 * 0.004 / kPipeRadius, mean = std::sin(a) / a;
  const double variance =
      kPipeRadius * kPipeRadius * (0.5 + 0.25 * std::sin(2 * a) / a - mean * mean);
  CHECK(e.one_plane == Approx(std::log(variance / 1e-6)).epsilon(0.1));
}

TEST_CASE("a surface seen from outside and from inside has convexities of opposite sign",
          "[evidence]") {
  SurfaceSamples samples = sphere_grid(15, 15, 0.05, 0.004, 0.0, 1);
  const Quadric ball(diagonal(1, 1, 1, -0.05 * 0.05));
  const Evidence outside = collect_evidence(samples, all_of(samples), ball);
  // Both principal curvatures are 1/R.
  CHECK(outside.convexity == Approx(2.0 / 0.05 * outside.size).epsilon(0.01));
  for (auto& n : samples.n) n = -n;
  const Evidence inside = collect_evidence(samples, all_of(samples), ball);
  CHECK(inside.convexity == Approx(-outside.convexity));
}

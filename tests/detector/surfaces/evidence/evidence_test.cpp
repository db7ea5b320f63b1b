#include "surfaces/evidence/evidence.hpp"

#include <cmath>

#include "detector/pipe.hpp"
#include "fit/family_spec.hpp"
#include "samples/region.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/evidence/confidence.hpp"

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
  std::vector<char> above(static_cast<std::size_t>(samples.size()), 0);
  for (const int i : all_of(samples)) {
    const int row = i / 25;
    if (row >= 10 && row < 30) middle.push_back(i);
    above[i] = row >= 30;
  }
  const Quadric Q = cylinder_quadric();
  const double alone = collect_evidence(samples, middle, Q).smooth_border;
  CHECK(alone > 0.3);
  CHECK(collect_evidence(samples, middle, Q, above).smooth_border ==
        Approx(0.5 * alone).epsilon(0.05));
}

TEST_CASE("border, edge and thickness are those of the closed form", "[evidence]") {
  const SurfaceSamples samples = cylinder_grid(21, 30, kPipeRadius, 0.004, 0.0, 1);
  const Evidence whole = collect_evidence(samples, all_of(samples), cylinder_quadric());
  CHECK(whole.open_border == 0.0);
  CHECK(whole.depth_edge == Approx(1.0 - 19.0 * 28.0 / (21.0 * 30.0)));
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
  const int dof = family_spec(Family::kCylinder).dof;
  CHECK(confidence(cylinder, dof) > 0.9);
  CHECK(confidence(planes, family_spec(Family::kEllipticCylinder).dof) < confidence(cylinder, dof));
}

TEST_CASE("residuals that neighbours share are a misfit, white noise and small flaws are not",
          "[evidence]") {
  const SurfaceSamples samples = cylinder_grid(25, 40, kPipeRadius, 0.004, 0.002, 3);
  const double fits = collect_evidence(samples, all_of(samples), cylinder_quadric()).misfit;
  // The mean over a sample and its eight neighbours.
  CHECK(fits == Approx(1.0 / 3.0).epsilon(0.25));
  const auto misfit_of_radius = [&](double radius) {
    const Quadric wide(diagonal(1, 1, 0, -radius * radius));
    return collect_evidence(samples, all_of(samples), wide).misfit;
  };
  CHECK(misfit_of_radius(kPipeRadius + 0.006) > 5.0 * fits);
  SurfaceSamples waves = samples;
  waves.common_noise = 0.8;
  CHECK(collect_evidence(waves, all_of(waves), cylinder_quadric()).misfit ==
        Approx(fits / std::sqrt(2.6)));
  // Without noise, a misfit of one is two percent of the size.
  const SurfaceSamples exact = cylinder_grid(25, 40, kPipeRadius, 0.004, 0.0, 3);
  const double size = normalisation_of(exact, all_of(exact)).scale;
  const double off = kPipeRadius + 0.02 * size;
  const Quadric wide(diagonal(1, 1, 0, -off * off));
  CHECK(collect_evidence(exact, all_of(exact), wide).misfit == Approx(1.0).epsilon(0.05));
}

#include "views/align.hpp"

#include <cmath>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d;

namespace {

constexpr double kSampleCell = 0.005;
const Vector3d kViewpoint(0.5, 0.6, 0.8);

/// Adds a square in the plane through the origin with a normal, with samples in rows.
/// @param half  number of samples from its middle to its edge
void add_square(const Vector3d& middle, const Vector3d& normal, int half, SurfaceSamples* samples) {
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  const int edge = 2 * half + 1, base = samples->size();
  for (int j = 0; j < edge; ++j) {
    for (int i = 0; i < edge; ++i) {
      const Vector3d p = middle + kSampleCell * ((i - half) * u + (j - half) * v);
      samples->p.push_back(p.cast<float>());
      samples->raw.push_back(p.cast<float>());
      samples->n.push_back(normal.cast<float>());
      samples->sigma.push_back(0.0005f);
      samples->cell.push_back(static_cast<float>(kSampleCell));
      samples->first.push_back(static_cast<int>(samples->neighbours.size()));
      for (int b = std::max(0, j - 1); b <= std::min(edge - 1, j + 1); ++b) {
        for (int a = std::max(0, i - 1); a <= std::min(edge - 1, i + 1); ++a) {
          samples->neighbours.push_back(base + b * edge + a);
        }
      }
    }
  }
}

void end_neighbours(SurfaceSamples* samples) {
  samples->first.push_back(static_cast<int>(samples->neighbours.size()));
}

/// The corner of a room, seen from kViewpoint.
SurfaceSamples corner() {
  SurfaceSamples samples;
  for (int axis = 0; axis < 3; ++axis) {
    Vector3d middle = Vector3d::Constant(0.15);
    middle[axis] = 0.0;
    add_square(middle, Vector3d::Unit(axis), 25, &samples);
  }
  end_neighbours(&samples);
  return samples;
}

SurfaceSamples bare_table() {
  SurfaceSamples samples;
  add_square(Vector3d::Zero(), Vector3d::UnitZ(), 40, &samples);
  end_neighbours(&samples);
  return samples;
}

/// A turn about the eye and a shift.
Eigen::Isometry3d motion(const Vector3d& turn, const Vector3d& shift) {
  return Eigen::Translation3d(kViewpoint + shift) *
         Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) *
         Eigen::Translation3d(-kViewpoint);
}

SurfaceSamples seen_after(SurfaceSamples samples, const Eigen::Isometry3d& X) {
  for (int i = 0; i < samples.size(); ++i) {
    samples.raw[i] = samples.p[i] = (X * samples.raw[i].cast<double>()).cast<float>();
    samples.n[i] = (X.linear() * samples.n[i].cast<double>()).cast<float>();
  }
  return samples;
}

}  // namespace

TEST_CASE("a shift or a turn is found if only that is looked for", "[views][align]") {
  const SurfaceSamples before = corner();
  ViewOptions shifted, turned;
  shifted.turn = turned.shift = 0.0;
  for (const double size : {0.5, 1.0, 1.5}) {
    const Eigen::Isometry3d shift =
        motion(Vector3d::Zero(), size * shifted.shift * Vector3d(-1.0, 0.5, 0.7));
    const Eigen::Isometry3d turn =
        motion(size * turned.turn * Vector3d(0.6, -1.0, 0.4), Vector3d::Zero());
    const auto back = align(seen_after(before, shift), kViewpoint, before, shifted);
    const auto turned_back = align(seen_after(before, turn), kViewpoint, before, turned);
    CAPTURE(size);
    REQUIRE(back);
    REQUIRE(turned_back);
    // The prior holds the motion back by some hundredths.
    CHECK((*back * shift * Vector3d::Zero()).norm() < 0.05 * shift.translation().norm());
    CHECK((*turned_back * turn * Vector3d::Zero()).norm() < 0.05 * turn.translation().norm());
    CHECK((turned_back->linear() * turn.linear()).isIdentity(0.05 * size * turned.turn));
  }
}

TEST_CASE("surfaces come together where both a shift and a turn may be", "[views][align]") {
  const SurfaceSamples before = corner();
  const ViewOptions options;
  const Eigen::Isometry3d X =
      motion(options.turn * Vector3d(0.6, -1.0, 0.4), options.shift * Vector3d(-1.0, 0.5, 0.7));
  const auto found = align(seen_after(before, X), kViewpoint, before, options);
  REQUIRE(found);
  // Small squares tell little of which of both it was, but where their middles are.
  for (int axis = 0; axis < 3; ++axis) {
    Vector3d middle = Vector3d::Constant(0.15);
    middle[axis] = 0.0;
    const double off = (X * middle - middle)[axis];
    CHECK(std::abs((*found * X * middle - middle)[axis]) < 0.1 * std::abs(off) + 5e-5);
  }
}

TEST_CASE("a table alone says nothing of shifts along it", "[views][align]") {
  const SurfaceSamples before = bare_table();
  ViewOptions options;
  options.turn = 0.0;
  const auto found = align(seen_after(before, motion(Vector3d::Zero(), {0.001, -0.001, 0.002})),
                           kViewpoint, before, options);
  REQUIRE(found);
  CHECK(found->translation().head<2>().norm() < 1e-6);
  CHECK(found->translation().z() == Approx(-0.002).epsilon(0.1));
}

TEST_CASE("a pose that is trusted is kept", "[views][align]") {
  const SurfaceSamples before = corner();
  ViewOptions options;
  options.shift = options.turn = 0.0;
  const auto found = align(seen_after(before, motion(Vector3d::Zero(), Vector3d::Constant(0.002))),
                           kViewpoint, before, options);
  REQUIRE(found);
  CHECK(found->matrix().isIdentity(0.0));
}

TEST_CASE("views with little in common, or poses that are far off, are not brought together",
          "[views][align][degenerate]") {
  const SurfaceSamples before = corner();
  const ViewOptions options;
  CHECK_FALSE(align(seen_after(before, motion(Vector3d::Zero(), {5.0, 0.0, 0.0})), kViewpoint,
                    before, options));
  CHECK_FALSE(align(SurfaceSamples(), kViewpoint, before, options));
  CHECK_FALSE(align(before, kViewpoint, SurfaceSamples(), options));
  // The pose is said to be far better than it is, so nothing matches within its errors.
  ViewOptions exact;
  exact.shift = exact.turn = 0.0004;
  CHECK_FALSE(align(seen_after(before, motion(Vector3d::Zero(), Vector3d::Constant(0.02))),
                    kViewpoint, before, exact));
}

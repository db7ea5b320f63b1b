#include "surfaces/evidence/axis_neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector_clones.hpp"
#include "fit/posed_quadric.hpp"
#include "samples/region.hpp"
#include "search/axes/normal_line.hpp"
#include "surfaces/evidence/box_test.hpp"

namespace quadrille {
namespace {

// The neighbourhood reaches so far beyond the region, in its largest radii.
constexpr float kReach = 1.5f;
// A wide surface that hardly bends has its axis far away. Radii are counted up to this multiple of
// the region's size.
constexpr double kMaxRadius = 3.0;

/// A cylinder about an axis, by the map to the frame of the axis.
struct AxisTest {
  AffineRows rows;
  float max_square, low, high;
};

/// Numbers of samples within the cylinder whose normal lines meet the axis, and of all those whose
/// normal lines have a direction.
struct LineCounts {
  int meet = 0, all = 0;
};

/// Counts samples as NormalLine does, with squares in place of roots.
QUADRILLE_VECTOR_CLONES
LineCounts count_lines(const AxisTest& t, const SampleRows& s) {
  constexpr float kMinSquare = NormalLine::kMinSine * NormalLine::kMinSine;
  constexpr float kCells = NormalLine::kMaxMissCells * NormalLine::kMaxMissCells;
  constexpr float kShare = NormalLine::kMaxMissShare * NormalLine::kMaxMissShare;
  int meet = 0, all = 0;
  for (int k = 0; k < s.size; ++k) {
    const float px = s.x[k], py = s.y[k], pz = s.z[k], qx = s.nx[k], qy = s.ny[k], qz = s.nz[k];
    const float x = t.rows.of_point(0, px, py, pz), y = t.rows.of_point(1, px, py, pz);
    const float z = t.rows.of_point(2, px, py, pz);
    const float nx = t.rows.of_direction(0, qx, qy, qz), ny = t.rows.of_direction(1, qx, qy, qz);
    const float square = x * x + y * y, sine = nx * nx + ny * ny;
    const float miss = x * ny - y * nx;
    const float max_miss = std::max(kCells * s.cell[k] * s.cell[k], kShare * square);
    const int counts =
        (z >= t.low) & (z <= t.high) & (square <= t.max_square) & (sine >= kMinSquare);
    all += counts;
    meet += counts & (miss * miss <= sine * max_miss);
  }
  return {meet, all};
}

}  // namespace

AxisNeighbours axis_neighbours(const SurfaceSamples& samples, const SampleBlocks& blocks,
                               std::span<const int> region, const Axis& axis) {
  const Normalisation local = normalisation_of(samples, region);
  const Eigen::Vector3d foot =
      axis.point + axis.direction * axis.direction.dot(local.centre - axis.point);
  const Eigen::Isometry3f X_AC = pose_along(foot, axis.direction).inverse().cast<float>();
  float radius = 0, low = 0, high = 0;
  for (const int i : region) {
    const Eigen::Vector3f x = X_AC * samples.raw[i];
    radius = std::max(radius, x.head<2>().squaredNorm());
    low = std::min(low, x.z()), high = std::max(high, x.z());
  }
  radius = kReach * std::min(std::sqrt(radius), static_cast<float>(kMaxRadius * local.scale));
  low -= radius, high += radius;
  const AxisTest test{AffineRows(X_AC), radius * radius, low, high};
  const Eigen::AlignedBox3f box(Eigen::Vector3f(-radius, -radius, low),
                                Eigen::Vector3f(radius, radius, high));
  // The region's own samples are counted with the others and then taken off.
  const SampleTable own(samples, region);
  LineCounts around, within = count_lines(test, own.rows());
  for (const SampleRows& rows : blocks.near_box(X_AC, box)) {
    const LineCounts counts = count_lines(test, rows);
    around.meet += counts.meet, around.all += counts.all;
  }
  const int meet = around.meet - within.meet, all = around.all - within.all;
  const double size = static_cast<double>(region.size());
  return {meet / size, (all - meet) / size};
}

}  // namespace quadrille

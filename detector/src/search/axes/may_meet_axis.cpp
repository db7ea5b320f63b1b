#include "search/axes/may_meet_axis.hpp"

#include <algorithm>
#include <cstddef>

#include "base/vector_clones.hpp"
#include "search/axes/normal_line.hpp"

namespace quadrille {
namespace {

// Factor of squares, for errors by rounding.
constexpr float kSlack = 1.04f;

constexpr float squared(float x) { return x * x; }

/// Compares samples with an axis through p along d.
/// @param x, n  positions and normals, one after the other
QUADRILLE_VECTOR_CLONES
void compare_with_axis(const float* p, const float* d, float max_square, int size,
                       const float* __restrict x, const float* __restrict n,
                       const float* __restrict cell, int* __restrict may) {
  const float px = p[0], py = p[1], pz = p[2], dx = d[0], dy = d[1], dz = d[2];
  constexpr float kMinSquare = squared(NormalLine::kMinSine) / kSlack;
  constexpr float kCells = kSlack * squared(NormalLine::kMaxMissCells);
  constexpr float kShare = kSlack * squared(NormalLine::kMaxMissShare);
  for (std::ptrdiff_t k = 0; k < size; ++k) {
    const float ox = x[3 * k] - px, oy = x[3 * k + 1] - py, oz = x[3 * k + 2] - pz;
    const float nx = n[3 * k], ny = n[3 * k + 1], nz = n[3 * k + 2];
    const float along = dx * ox + dy * oy + dz * oz, height = dx * nx + dy * ny + dz * nz;
    // Squares of the distance from the axis, and of the sine between normal and axis.
    const float square = ox * ox + oy * oy + oz * oz - along * along;
    const float sine = nx * nx + ny * ny + nz * nz - height * height;
    // The distance at which the normal line passes the axis, times the sine.
    const float miss =
        dx * (oy * nz - oz * ny) + dy * (oz * nx - ox * nz) + dz * (ox * ny - oy * nx);
    const float max_miss = std::max(kCells * cell[k] * cell[k], kShare * square);
    may[k] = (square <= max_square) & (sine >= kMinSquare) & (miss * miss <= sine * max_miss);
  }
}

}  // namespace

void may_meet_axis(const SurfaceSamples& samples, int begin, int end, const Eigen::Vector3f& point,
                   const Eigen::Vector3f& direction, float reach, int* may) {
  compare_with_axis(point.data(), direction.data(), kSlack * squared(reach), end - begin,
                    samples.raw[begin].data(), samples.n[begin].data(), &samples.cell[begin], may);
}

}  // namespace quadrille

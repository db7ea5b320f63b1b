#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "samples/surface_samples.hpp"
#include "search/basis.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

/// Samples on a grid of a parametric surface, each with the up to eight around it as neighbours.
///
/// @param surface  (column, row) to the oriented point there
/// @param cell     distance between samples [m]
/// @param noise    standard deviation of the raw positions along the normals [m]
template <class Surface>
SurfaceSamples surface_grid(int columns, int rows, Surface&& surface, double cell, double noise,
                            std::uint64_t seed) {
  SurfaceSamples samples;
  RandomStream random(seed, 0);
  samples.first.push_back(0);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const OrientedPoint point = surface(i, j);
      samples.p.push_back(point.x.template cast<float>());
      samples.n.push_back(point.n.template cast<float>());
      samples.raw.push_back((point.x + noise * gaussian(random) * point.n).template cast<float>());
      samples.sigma.push_back(static_cast<float>(std::max(1e-4, noise)));
      samples.cell.push_back(static_cast<float>(cell));
      samples.count.push_back(1);
      samples.source.push_back(j * columns + i);
      for (int y = std::max(0, j - 1); y <= std::min(rows - 1, j + 1); ++y) {
        for (int x = std::max(0, i - 1); x <= std::min(columns - 1, i + 1); ++x) {
          if (x != i || y != j) samples.neighbours.push_back(y * columns + x);
        }
      }
      samples.first.push_back(static_cast<int>(samples.neighbours.size()));
    }
  }
  return samples;
}

/// The part of a cylinder of that radius along z that faces x, of samples about `cell` apart.
inline SurfaceSamples cylinder_grid(int columns, int rows, double radius, double cell, double noise,
                                    std::uint64_t seed) {
  return surface_grid(
      columns, rows,
      [&](int i, int j) {
        const double angle = (i - 0.5 * (columns - 1)) * cell / radius;
        const Eigen::Vector3d n(std::cos(angle), std::sin(angle), 0.0);
        return OrientedPoint{radius * n + (j - 0.5 * (rows - 1)) * cell * Eigen::Vector3d::UnitZ(),
                             n};
      },
      cell, noise, seed);
}

/// The part of a sphere around the origin that faces x.
inline SurfaceSamples sphere_grid(int columns, int rows, double radius, double cell, double noise,
                                  std::uint64_t seed) {
  return surface_grid(
      columns, rows,
      [&](int i, int j) {
        const double a = (i - 0.5 * (columns - 1)) * cell / radius;
        const double b = (j - 0.5 * (rows - 1)) * cell / radius;
        const Eigen::Vector3d n(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
        return OrientedPoint{radius * n, n};
      },
      cell, noise, seed);
}

/// A square patch of the plane x = 0, normals along x.
inline SurfaceSamples plane_grid(int columns, int rows, double cell, double noise,
                                 std::uint64_t seed) {
  return surface_grid(
      columns, rows,
      [&](int i, int j) {
        return OrientedPoint{{0.0, (i - 0.5 * (columns - 1)) * cell, (j - 0.5 * (rows - 1)) * cell},
                             Eigen::Vector3d::UnitX()};
      },
      cell, noise, seed);
}

/// All indices of the samples.
inline std::vector<int> all_of(const SurfaceSamples& samples) {
  std::vector<int> list;
  for (int i = 0; i < samples.size(); ++i) list.push_back(i);
  return list;
}

}  // namespace quadrille::test

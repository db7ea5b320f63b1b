#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <vector>

#include "samples/surface_samples.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

/// A surface by its points and outward normals, a sample's cell apart.
struct OrientedPoints {
  std::vector<Eigen::Vector3d> p, n;
};

inline constexpr double kSampleCell = 0.004;

/// The six sides of a box around the origin, a cell apart and half a cell from the edges.
inline OrientedPoints sides_of_box(const Eigen::Vector3d& size) {
  OrientedPoints all;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const double side : {-1.0, 1.0}) {
      for (double a = 0.5 * (kSampleCell - size[u]); a < 0.5 * size[u]; a += kSampleCell) {
        for (double b = 0.5 * (kSampleCell - size[v]); b < 0.5 * size[v]; b += kSampleCell) {
          Eigen::Vector3d p;
          p[axis] = 0.5 * side * size[axis];
          p[u] = a;
          p[v] = b;
          all.p.push_back(p);
          all.n.push_back(side * Eigen::Vector3d::Unit(axis));
        }
      }
    }
  }
  return all;
}

/// The samples that an eye at the origin of C has of a convex thing. Samples within two cells are
/// neighbours; normals are off by `noise` [rad].
inline SurfaceSamples seen_samples(const OrientedPoints& thing_B, const Eigen::Isometry3d& X_CB,
                                   double noise = 0.0, std::uint64_t seed = 1) {
  SurfaceSamples samples;
  RandomStream random(seed, 0);
  for (std::size_t k = 0; k < thing_B.p.size(); ++k) {
    const Eigen::Vector3d p = X_CB * thing_B.p[k];
    Eigen::Vector3d n = X_CB.linear() * thing_B.n[k];
    if (n.dot(p) >= 0.0) continue;
    for (double& x : n) x += noise * gaussian(random);
    samples.p.push_back(p.cast<float>());
    samples.n.push_back(n.normalized().cast<float>());
    samples.raw.push_back(p.cast<float>());
    samples.sigma.push_back(0.0005f);
    samples.cell.push_back(static_cast<float>(kSampleCell));
    samples.count.push_back(9);
    samples.source.push_back(static_cast<int>(k));
  }
  samples.first.push_back(0);
  for (const Eigen::Vector3f& p : samples.p) {
    for (int k = 0; k < samples.size(); ++k) {
      const float apart = (samples.p[k] - p).norm();
      if (apart > 0.0f && apart < 2.0 * kSampleCell) samples.neighbours.push_back(k);
    }
    samples.first.push_back(static_cast<int>(samples.neighbours.size()));
  }
  return samples;
}

/// A box before the eye that shows it three sides.
inline Eigen::Isometry3d showing_three_sides() {
  return translation(0.05, -0.02, 0.6) * Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY());
}

}  // namespace quadrille::test

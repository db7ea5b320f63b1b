#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "fit/posed_quadric.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille::test {

/// A bottle of revolution about z: a wall of radius 40 mm from 0 to 100 mm, a conic shoulder to 15
/// mm at 130 mm, and a neck up to 170 mm.
inline constexpr float kWall = 0.04f, kNeck = 0.015f;

/// Adds a sample with neither neighbours nor noise of its own.
inline void add_sample(SurfaceSamples* samples, const Eigen::Vector3f& p,
                       const Eigen::Vector3f& n) {
  samples->p.push_back(p), samples->raw.push_back(p);
  samples->n.push_back(n.normalized());
  samples->sigma.push_back(0.0005f), samples->cell.push_back(0.003f);
  samples->count.push_back(9), samples->source.push_back(samples->size() - 1);
  if (samples->first.empty()) samples->first.push_back(0);
  samples->first.push_back(0);
}

/// Samples of the half of the bottle that faces +x, 3 mm apart, with Gaussian errors of the
/// positions [m] and of the normals [rad].
inline SurfaceSamples bottle(const Eigen::Isometry3d& X_CB, double noise, double tilt) {
  SurfaceSamples samples;
  std::mt19937 engine(1);
  std::normal_distribution<float> error(0.0f, 1.0f);
  const float slope = (kNeck - kWall) / 0.03f;
  for (float h = 0.0015f; h < 0.17f; h += 0.003f) {
    const bool shoulder = h > 0.1f && h < 0.13f;
    const float r = h <= 0.1f ? kWall : shoulder ? kWall + slope * (h - 0.1f) : kNeck;
    const float step = 0.003f / r;
    for (float turn = -1.5f; turn < 1.5f; turn += step) {
      const Eigen::Vector3f u(std::cos(turn), std::sin(turn), 0.0f);
      const Eigen::Vector3f n =
          shoulder ? Eigen::Vector3f(u - slope * Eigen::Vector3f::UnitZ()) : u;
      const Eigen::Vector3f blur(error(engine), error(engine), error(engine));
      const Eigen::Vector3f off(error(engine), error(engine), error(engine));
      add_sample(&samples,
                 X_CB.cast<float>() * Eigen::Vector3f(r * u + Eigen::Vector3f(0, 0, h) +
                                                      static_cast<float>(noise) * blur),
                 X_CB.linear().cast<float>() * (n.normalized() + static_cast<float>(tilt) * off));
    }
  }
  return samples;
}

/// Adds samples of random places, up to 0.2 m from the origin of the bottle, and random normals.
inline void add_outliers(SurfaceSamples* samples, const Eigen::Isometry3d& X_CB, int count) {
  std::mt19937 engine(2);
  std::uniform_real_distribution<float> place(-0.2f, 0.2f);
  std::normal_distribution<float> direction(0.0f, 1.0f);
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3f p(place(engine), place(engine), place(engine));
    const Eigen::Vector3f n(direction(engine), direction(engine), direction(engine));
    add_sample(samples, X_CB.cast<float>() * p, n);
  }
}

/// A pose of the bottle that is aligned with no axis of the frame.
inline Eigen::Isometry3d some_pose() {
  return pose_along({0.1, -0.2, 0.9}, Eigen::Vector3d(0.2, -0.8, -0.55).normalized());
}

/// Distance of a point from the bottle's axis [m].
inline double off_axis(const Eigen::Isometry3d& X_CB, const Eigen::Vector3d& p_C) {
  return (X_CB.inverse() * p_C).head<2>().norm();
}

}  // namespace quadrille::test

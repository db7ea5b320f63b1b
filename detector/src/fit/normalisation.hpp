#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// A similarity that carries points to about the unit ball, as the paper asks (Hartley's
/// normalisation): x_local = (x − centre) / scale.
struct Normalisation {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double scale = 1.0;

  /// Transforms a quadric from local coordinates to the frame of the samples.
  Quadric to_frame(const Eigen::Matrix4d& Q_local) const;
  /// Transforms a quadric from the frame of the samples to local coordinates.
  Eigen::Matrix4d to_local(const Quadric& Q) const;
};

/// The distance from the centroid that becomes 1. One stray point hardly changes the root mean
/// square; the largest distance puts all points into the unit ball.
enum class Radius { kRootMeanSquare, kLargest };

/// The normalisation about the centroid of some points.
/// @param point  returns the i-th of `size` points in double precision; `size` is at least 1
template <typename PointAt>
Normalisation normalisation_about_centroid(std::size_t size, Radius radius, const PointAt& point) {
  Normalisation result;
  for (std::size_t i = 0; i < size; ++i) result.centre += point(i);
  result.centre /= static_cast<double>(size);
  double sum = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    const double square = (point(i) - result.centre).squaredNorm();
    sum += square;
    largest = std::max(largest, square);
  }
  const bool mean = radius == Radius::kRootMeanSquare;
  result.scale = std::sqrt(mean ? sum / static_cast<double>(size) : largest);
  return result;
}

}  // namespace quadrille

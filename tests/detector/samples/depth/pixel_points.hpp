#pragma once

#include <vector>

#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::test {

/// A cloud of points with these tangents and inverse depths.
inline PointCloud cloud_of(const std::vector<Eigen::Vector3f>& uvw) {
  PointCloud cloud;
  for (const Eigen::Vector3f& t : uvw) {
    cloud.points.push_back(Eigen::Vector3f(t.x(), t.y(), 1.0f) / t.z());
  }
  return cloud;
}

/// An image of square pixels whose first corner is on the axis.
inline PinholeImage image_of(int width, int height, float pitch) {
  return {Eigen::Array2f::Zero(), Eigen::Array2f::Constant(pitch), width, height};
}

}  // namespace quadrille::test

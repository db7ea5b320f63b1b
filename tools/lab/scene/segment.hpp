#pragma once

#include <Eigen/Core>

namespace quadrille::scene {

/// A straight line segment from a to b.
struct Segment {
  Eigen::Vector3d a, b;
};

/// Returns the least distance between two segments.
double distance(const Segment& s, const Segment& t);

}  // namespace quadrille::scene

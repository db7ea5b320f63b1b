#pragma once

#include <Eigen/Core>

namespace quadrille::scene {

/// A straight piece from a to b.
struct Segment {
  Eigen::Vector3d a, b;
};

/// Least distance of two segments.
double distance(const Segment& s, const Segment& t);

}  // namespace quadrille::scene

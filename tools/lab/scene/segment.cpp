#include "lab/scene/segment.hpp"

#include <algorithm>

namespace quadrille::scene {
namespace {

/// Returns the position along a segment, 0 to 1, that is nearest to a point.
double foot(const Segment& s, const Eigen::Vector3d& x) {
  const Eigen::Vector3d d = s.b - s.a;
  const double square = d.squaredNorm();
  return square > 0.0 ? std::clamp((x - s.a).dot(d) / square, 0.0, 1.0) : 0.0;
}

}  // namespace

double distance(const Segment& s, const Segment& t) {
  const Eigen::Vector3d d = s.b - s.a, e = t.b - t.a, r = s.a - t.a;
  const double a = d.squaredNorm(), b = d.dot(e), c = e.squaredNorm();
  // The determinant is zero for parallel segments, on which any start will do.
  const double determinant = a * c - b * b;
  double u = 0.0;
  if (determinant > 1e-12 * a * c) {
    u = std::clamp((b * e.dot(r) - c * d.dot(r)) / determinant, 0.0, 1.0);
  }
  // The distance is convex, so it suffices to project onto each segment in turn.
  const double v = foot(t, s.a + u * d);
  u = foot(s, t.a + v * e);
  return (s.a + u * d - t.a - v * e).norm();
}

}  // namespace quadrille::scene

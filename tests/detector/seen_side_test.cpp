#include "quadrille/detector/detection.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// A detection with the quadric diag(a, b, c, d) of its own frame, seen between two heights.
Detection seen_between(QuadricType type, const Eigen::Vector4d& diagonal, double low, double high) {
  Detection d;
  d.type = type;
  d.X_CQ = Eigen::Translation3d(0.1, -0.2, 0.7) *
           Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 2, -1).normalized());
  d.Q_C = Quadric(Eigen::Matrix4d(diagonal.asDiagonal())).transformed(d.X_CQ);
  d.extent_Q = {Eigen::Vector3d(-0.1, -0.1, low), Eigen::Vector3d(0.1, 0.1, high)};
  return d;
}

}  // namespace

TEST_CASE("round surfaces know which of their sides was seen", "[detection]") {
  const double r2 = 0.04 * 0.04;
  for (const Detection& outer :
       {seen_between(QuadricType::kSphere, {1, 1, 1, -r2}, 0.01, 0.04),
        seen_between(QuadricType::kCylinder, {1, 1, 0, -r2}, -0.05, 0.05),
        seen_between(QuadricType::kCone, {1, 1, -0.1, 0}, 0.05, 0.2),
        seen_between(QuadricType::kHyperboloidOneSheet, {1, 1, -0.1, -r2}, -0.05, 0.05),
        seen_between(QuadricType::kHyperboloidTwoSheets, {1, 1, -1, r2}, 0.04, 0.2)}) {
    Detection inner = outer;
    inner.Q_C = outer.Q_C.flipped();
    INFO(to_string(outer.type));
    CHECK_FALSE(shows_inside(outer));
    CHECK(shows_inside(inner));
  }
}

TEST_CASE("what has no inside was not seen from there", "[detection]") {
  const Detection saddle =
      seen_between(QuadricType::kHyperbolicCylinder, {1, -1, 0, 0.01}, -0.1, 0.1);
  Detection other = saddle;
  other.Q_C = saddle.Q_C.flipped();
  CHECK_FALSE(shows_inside(saddle));
  CHECK_FALSE(shows_inside(other));
  CHECK_FALSE(shows_inside({}));
}

#include "space/surface_cover.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3f;

TEST_CASE("the cubes of added points and those beside them are covered", "[space]") {
  const Eigen::AlignedBox3d region(Eigen::Vector3d(-0.1, -0.2, 0.3),
                                   Eigen::Vector3d(0.2, 0.1, 0.6));
  constexpr float kEdge = 0.01f;
  // More points than are looked at together, all of which but one lie elsewhere or count for
  // nothing.
  std::vector<Vector3f> points(200, Vector3f(0.05f, 0.005f, 5.0f));
  std::vector<std::uint8_t> left_out(points.size(), 0);
  points[3] = Vector3f(0.15f, -0.15f, 0.35f);
  left_out[3] = 1;
  points[70] = Vector3f(NAN, 0.0f, 0.4f);
  points[90] = Vector3f(-0.105f, 0.0f, 0.4f);
  points[150] = Vector3f(0.055f, -0.045f, 0.455f);
  SurfaceCover cover(region, kEdge);
  cover.add(points, left_out);
  int covered = 0;
  for (int i = 0; i < 30; ++i) {
    for (int j = 0; j < 30; ++j) {
      for (int k = 0; k < 30; ++k) {
        const Vector3f p =
            Vector3f(-0.1f, -0.2f, 0.3f) +
            kEdge * (Vector3f(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)) +
                     Vector3f::Constant(0.5f));
        const bool near = ((p - points[150]).cwiseAbs().array() < 1.2f * kEdge).all();
        CHECK(cover.covers(p) == near);
        covered += near;
      }
    }
  }
  CHECK(covered == 27);
  CHECK_FALSE(cover.covers(points[70]));
  CHECK_FALSE(cover.covers(points[0]));
}

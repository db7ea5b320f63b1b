#include "surfaces/evidence/smooth_parts.hpp"

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr int kStripColumns = 20, kStripRows = 10;

/// Two faces of a box that meet along z in the middle column.
SurfaceSamples box_edge() {
  return surface_grid(
      kStripColumns, kStripRows,
      [](int i, int j) {
        const double s = (i - 9.5) * 0.004, z = j * 0.004;
        return s < 0 ? OrientedPoint{{0, s, z}, -Eigen::Vector3d::UnitX()}
                     : OrientedPoint{{s, 0, z}, -Eigen::Vector3d::UnitY()};
      },
      0.004, 0.0, 1);
}

}  // namespace

TEST_CASE("smooth parts end at creases and nowhere else", "[smooth_parts]") {
  const SurfaceSamples edge = box_edge();
  const SmoothParts two(edge);
  CHECK(two.size() == 2);
  for (int k = 0; k < edge.size(); ++k) CHECK(two.part_of(k) == (k % kStripColumns < 10 ? 0 : 1));
  CHECK(SmoothParts(cylinder_grid(20, 10, 0.04, 0.004, 0.0, 1)).size() == 1);
  CHECK(SmoothParts(SurfaceSamples()).size() == 0);
}

#include "surfaces/smooth_parts.hpp"

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

std::vector<int> columns(int from, int to) {
  std::vector<int> list;
  for (int k = 0; k < kStripColumns * kStripRows; ++k) {
    if (k % kStripColumns >= from && k % kStripColumns < to) list.push_back(k);
  }
  return list;
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

TEST_CASE("the remainder is what a region leaves over of its parts", "[smooth_parts]") {
  SmoothParts parts(box_edge());
  CHECK(parts.remainder(columns(0, 10)) == 0.0);
  // Four of ten columns: six are left.
  CHECK(parts.remainder(columns(0, 4)) == Approx(1.5));
  // Half of the region lies in each part, each of which leaves 5 of its 10 columns over.
  CHECK(parts.remainder(columns(5, 15)) == Approx(0.5));
  // What another surface holds is explained, and a claimed region leaves the same over.
  parts.claim(columns(0, 7));
  CHECK(parts.remainder(columns(0, 4)) == Approx(0.75));
  parts.claim(columns(0, 7));
  CHECK(parts.remainder(columns(0, 4)) == Approx(0.75));
}

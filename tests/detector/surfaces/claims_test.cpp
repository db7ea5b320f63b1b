#include "surfaces/claims.hpp"

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr int kClaimedColumns = 20, kClaimedRows = 10;

/// Two faces of a box that meet along z in the middle column.
SurfaceSamples claimed_edge() {
  return surface_grid(
      kClaimedColumns, kClaimedRows,
      [](int i, int j) {
        const double s = (i - 9.5) * 0.004, z = j * 0.004;
        return s < 0 ? OrientedPoint{{0, s, z}, -Eigen::Vector3d::UnitX()}
                     : OrientedPoint{{s, 0, z}, -Eigen::Vector3d::UnitY()};
      },
      0.004, 0.0, 1);
}

std::vector<int> columns(int from, int to) {
  std::vector<int> list;
  for (int k = 0; k < kClaimedColumns * kClaimedRows; ++k) {
    if (k % kClaimedColumns >= from && k % kClaimedColumns < to) list.push_back(k);
  }
  return list;
}

}  // namespace

TEST_CASE("the remainder is what a region leaves over of its parts", "[claims]") {
  Claims claims(claimed_edge());
  CHECK(claims.remainder(columns(0, 10)) == 0.0);
  // Four of ten columns: six are left.
  CHECK(claims.remainder(columns(0, 4)) == Approx(1.5));
  // Half of the region lies in each part, each of which leaves 5 of its 10 columns over.
  CHECK(claims.remainder(columns(5, 15)) == Approx(0.5));
  // What another surface holds is explained, and a claimed region leaves the same over.
  claims.add(columns(0, 7));
  CHECK(claims.remainder(columns(0, 4)) == Approx(0.75));
  claims.add(columns(0, 7));
  CHECK(claims.remainder(columns(0, 4)) == Approx(0.75));
}

TEST_CASE("what was claimed is open no more", "[claims]") {
  Claims claims(claimed_edge());
  CHECK(claims.open_of(columns(0, 4)) == columns(0, 4));
  claims.add(columns(0, 2));
  CHECK(claims.open_of(columns(0, 4)) == columns(2, 4));
  for (const int k : columns(0, kClaimedColumns))
    CHECK((claims.free()[k] == 0) == (k % kClaimedColumns < 2));
}

#include "boxes/join_boxes.hpp"

#include <array>
#include <utility>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// A box of 100 x 60 x 40 mm with its middle at x [m].
Box box_at(double x, int id, std::array<bool, 3> seen, std::vector<int> faces) {
  Box box;
  box.id = id;
  box.faces = std::move(faces);
  box.X_CB.translation().x() = x;
  box.size = {0.1, 0.06, 0.04};
  box.seen = seen;
  box.inner_B = box.outer_B = {-0.5 * box.size, 0.5 * box.size};
  return box;
}

}  // namespace

TEST_CASE("of a box that two views show the one with more seen sides is kept, with all faces",
          "[boxes][views]") {
  const Box one = box_at(0.5, 7, {true, true, false}, {3});
  const Box other = box_at(0.503, 7, {true, true, true}, {3, 4});
  for (const auto& views : {std::vector<std::vector<Box>>{{one}, {other}}, {{other}, {one}}}) {
    const std::vector<Box> joined = join_boxes(views);
    REQUIRE(joined.size() == 1);
    CHECK(joined[0].id == 7);
    CHECK(joined[0].X_CB.translation().x() == 0.503);
    CHECK(joined[0].seen == std::array<bool, 3>{true, true, true});
    CHECK(joined[0].faces == std::vector<int>{3, 4});
  }
}

TEST_CASE("boxes beside each other stay apart, and are numbered anew", "[boxes][views]") {
  const std::vector<Box> joined = join_boxes(
      {{box_at(0.5, 7, {true, true, true}, {3})},
       {box_at(0.62, 7, {true, true, true}, {4}), box_at(0.5, 8, {true, false, true}, {5})}});
  REQUIRE(joined.size() == 2);
  CHECK(joined[0].id == 7);
  CHECK(joined[1].id == 8);
  CHECK(joined[0].X_CB.translation().x() != joined[1].X_CB.translation().x());
}

TEST_CASE("two boxes that one view shows in each other stay two", "[boxes][views]") {
  const Box outer = box_at(0.5, 7, {true, true, true}, {3}), inner = box_at(0.51, 8, {}, {4});
  CHECK(join_boxes({{outer, inner}, {}}).size() == 2);
  CHECK(join_boxes({{outer, inner}}).size() == 2);
  CHECK(join_boxes({{}, {}}).empty());
}

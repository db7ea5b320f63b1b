#include "bodies/axial_part.hpp"

#include <algorithm>
#include <vector>

#include "support/catch.hpp"

namespace quadrille {
namespace {

/// A part of 10 cm about the z axis.
AxialPart part_at(double height) {
  AxialPart part;
  part.middle_C = {0.0, 0.0, height};
  part.axis_C = Eigen::Vector3d::UnitZ();
  part.radius = 0.03;
  part.half_length = 0.05;
  return part;
}

TEST_CASE("parts that follow each other along an axis are one body, in whatever order they come",
          "[bodies]") {
  std::vector<int> order = {0, 1, 2, 3};
  do {
    std::vector<AxialPart> parts;
    for (const int place : order) parts.push_back(part_at(0.1 * place));
    CAPTURE(order);
    CHECK(groups_of(parts) == std::vector<int>(4, 0));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("parts far apart on one axis are bodies of their own", "[bodies]") {
  CHECK(groups_of({part_at(0.0), part_at(0.4), part_at(0.1)}) == std::vector<int>{0, 1, 0});
}

}  // namespace
}  // namespace quadrille

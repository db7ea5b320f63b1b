#include "contacts/pad_cover.hpp"

#include "quadrille/grasping/gripper.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// Points every millimetre over the pads of the Franka Hand around the origin, as far along the
/// closing direction as side(x, z) says.
template <class Side>
PadCover cover_of(Side&& side, double z_min = -0.009) {
  const Gripper hand = franka_hand();
  PadCover cover(0.0, hand.finger_front, hand);
  for (double x = -0.0085; x < 0.0087; x += 0.001) {
    for (double z = z_min + 0.0005; z < 0.009; z += 0.001) {
      cover.add({x, side(x, z), z});
      cover.add({x, -0.02, z});
    }
  }
  return cover;
}

}  // namespace

TEST_CASE("a slab fills the pads and is flat", "[contacts][points]") {
  const PadCover cover = cover_of([](double, double) { return 0.02; });
  CHECK(cover.filled() == 1.0);
  CHECK(cover.flat() == 1.0);
}

TEST_CASE("only the tips hold what ends half way up the pads", "[contacts][points]") {
  const PadCover cover = cover_of([](double, double) { return 0.02; }, 0.0);
  CHECK(cover.filled() == 0.5);
  CHECK(cover.flat() == 0.5);
}

TEST_CASE("a slope reaches out to a pad at few places", "[contacts][points]") {
  // At 45° the outermost point is at the tips, and points within 3 mm of it are as near to them.
  const PadCover cover = cover_of([](double, double z) { return 0.02 + z; });
  CHECK(cover.filled() == 1.0);
  CHECK(cover.flat() == Approx(1.0 / 6.0));
}

TEST_CASE("what lies beside the pads does not count", "[contacts][points]") {
  const Gripper hand = franka_hand();
  PadCover cover(0.0, hand.finger_front, hand);
  for (const double x : {-0.02, 0.02}) cover.add({x, 0.0, 0.0});
  for (const double z : {-0.02, 0.02}) cover.add({0.0, 0.0, z});
  CHECK(cover.filled() == 0.0);
  CHECK(cover.flat() == 0.0);
}

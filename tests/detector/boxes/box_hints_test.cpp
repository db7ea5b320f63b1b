#include "boxes/box_hints.hpp"

#include <vector>

#include "box_samples.hpp"
#include "boxes/box_ends.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

/// A box whose three seen sides lie on one detection.
struct OwnedBox {
  SurfaceSamples samples =
      test::seen_samples(test::sides_of_box({0.08, 0.048, 0.064}), test::showing_three_sides());
  Mask free = Mask(samples.p.size(), 0);
  std::vector<int> owner = std::vector<int>(samples.p.size(), 3);

  BoxHints hints(const Detection& detection, std::size_t view = 0) const {
    return find_box_hints(samples, {}, free, {detection}, owner, view);
  }
};

Detection plane_of(double side) {
  Detection plane;
  plane.id = 3;
  const Eigen::Vector3d half(0.5 * side, 0.01, 0.0);
  plane.extent_Q = {-half, half};
  return plane;
}

TEST_CASE("planes are sides of seeds if they are no longer than half the longest box",
          "[boxes][hints]") {
  const OwnedBox box;
  CHECK(box.hints(plane_of(0.99 * 0.5 * kMaxSide)).seeds.size() == 1);
  CHECK(box.hints(plane_of(1.01 * 0.5 * kMaxSide)).seeds.empty());
}

TEST_CASE("samples of curved detections and of other views are no hints", "[boxes][hints]") {
  OwnedBox box;
  Detection cylinder = plane_of(0.1);
  cylinder.type = QuadricType::kCylinder;
  CHECK(box.hints(cylinder).seeds.empty());
  CHECK(box.hints(cylinder).patches.empty());
  box.samples.view.assign(box.samples.p.size(), 1);
  CHECK(box.hints(plane_of(0.1), 0).seeds.empty());
  CHECK(box.hints(plane_of(0.1), 1).seeds.size() == 1);
}

TEST_CASE("free samples make a patch of each flat side, and those of planes make none",
          "[boxes][hints]") {
  OwnedBox box;
  CHECK(box.hints(plane_of(0.1)).patches.empty());
  box.free.assign(box.samples.p.size(), 1);
  CHECK(box.hints(plane_of(0.1)).patches.size() == 3);
}

TEST_CASE("without samples there are no hints", "[boxes][hints]") {
  const BoxHints hints = find_box_hints({}, {}, {}, {plane_of(0.1)}, {}, 0);
  CHECK(hints.patches.empty());
  CHECK(hints.seeds.empty());
}

}  // namespace
}  // namespace quadrille

#include <cstdint>

#include "lab/scoring/score.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

// Where spheres have no rival family, the search reports one on every second scene's cones,
// ellipsoids and paraboloids.
TEST_CASE("the search for spheres alone finds the spheres and mistakes no other surface for one",
          "[bench][spheres]") {
  scoring::FrameScore total;
  for (std::uint64_t seed = 5000; seed < 5012; ++seed) {
    const scoring::Frame frame =
        scoring::frame_of(scene::make_scene({scene::Family::kMedium, seed}));
    const DetectionResult result = detect(frame.cloud, sphere_preset());
    for (const Detection& d : result.detections) CHECK(d.type == QuadricType::kSphere);
    CHECK(result.boxes.empty());
    total += scoring::score(frame, scoring::findings_of(result), "sphere");
  }
  CHECK(total.wanted >= 4);
  CHECK(total.found == total.wanted);
  CHECK(total.wrong == 0);
}

}  // namespace
}  // namespace quadrille

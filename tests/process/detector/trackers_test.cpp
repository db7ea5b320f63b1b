#include "process/detector/trackers.hpp"

#include "support/catch.hpp"

namespace quadrille {

TEST_CASE("each camera keeps its tracker, and there are no more than allowed", "[process][track]") {
  Trackers trackers({});
  Tracker* const left = &trackers.of("A", "left");
  CHECK(&trackers.of("A", "right") != left);
  CHECK(&trackers.of("B", "left") != left);
  CHECK(&trackers.of("A", "left") == left);
  // A sender that names its frame anew each time.
  for (int n = 0; n < 100; ++n) {
    trackers.of("A", "frame " + std::to_string(n));
    // What is used is kept.
    CHECK(&trackers.of("A", "left") == left);
  }
  CHECK(trackers.given_up() == 103 - static_cast<int>(Trackers::kMaxTrackers));
}

}  // namespace quadrille

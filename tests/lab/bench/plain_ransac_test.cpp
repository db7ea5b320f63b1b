#include "lab/bench/plain_ransac.hpp"

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::bench {
namespace {

using scoring::Frame;
using scoring::FrameScore;

TEST_CASE("a baseline finds the same each time", "[bench][determinism]") {
  const Frame frame = test::make_known_frame();
  const auto first = plain_ransac(frame.cloud.points, {});
  const auto again = plain_ransac(frame.cloud.points, {});
  REQUIRE_FALSE(first.empty());
  REQUIRE(first.size() == again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(first[i].Q_C.matrix() == again[i].Q_C.matrix());
  }
}

TEST_CASE("a baseline finds planes even without trials, and nothing where nothing is",
          "[bench][degenerate]") {
  CHECK(plain_ransac({}, {}).empty());
  PlainOptions options;
  options.rounds = 0;
  const auto planes = plain_ransac(test::make_known_frame().cloud.points, options);
  REQUIRE(planes.size() == 1);
  const FrameScore s = scoring::score(test::make_known_frame(), planes);
  CHECK(s.planes_found == 1);
  CHECK(s.found == 0);
}

}  // namespace
}  // namespace quadrille::bench

#include "lab/bench/contender.hpp"
#include "lab/scoring/score.hpp"
#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::bench {
namespace {

TEST_CASE("the peers find the ball", "[bench][contender][peers]") {
  const Frame frame = test::make_known_frame();
  int peers = 0;
  for (const Contender& contender : all_contenders(QUADRILLE_PROGRAMS)) {
    if (contender.name != "cgal" && contender.name != "pcl") continue;
    if (!contender.absent.empty()) continue;
    INFO(contender.name);
    const scoring::FrameScore s = scoring::score(frame, contender.run(frame).findings);
    CHECK(s.found == 1);
    CHECK(s.planes_found == 1);
    ++peers;
  }
  // Built only where one of them is.
  CHECK(peers > 0);
}

}  // namespace
}  // namespace quadrille::bench

#include "lab/confidence/observe.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"

namespace quadrille::confidence_training {
namespace {

TEST_CASE("right and wrong surfaces of a scene are told, curved and flat, with finite terms",
          "[confidence]") {
  const scoring::Frame frame = scoring::frame_of(scene::make_scene({scene::Family::kHard, 1000}));
  DetectorOptions options;
  // Nothing is accepted: each candidate is weighed as if nothing else had been found.
  options.aggregate.min_confidence = options.aggregate.min_confidence_early = 1.0;
  const auto observations = observe(frame, options);
  for (const bool flat : {false, true}) {
    CAPTURE(flat);
    const auto all = std::count_if(observations.begin(), observations.end(),
                                   [&](const Observation& o) { return o.flat == flat; });
    const auto right =
        std::count_if(observations.begin(), observations.end(),
                      [&](const Observation& o) { return o.flat == flat && o.right; });
    CHECK(right >= 3);
    if (!flat) CHECK(right < all);
  }
  for (const Observation& o : observations) {
    for (const double term : o.terms) CHECK(std::isfinite(term));
  }
  // As the detector works, what is claimed is not weighed again.
  CHECK(observe(frame, {}).size() < observations.size());
}

TEST_CASE("a cloud of which nothing can be made has no observations", "[confidence][degenerate]") {
  CHECK(observe(scoring::Frame(), {}).empty());
}

}  // namespace
}  // namespace quadrille::confidence_training

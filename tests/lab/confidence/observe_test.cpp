#include "lab/confidence/observe.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"

namespace quadrille::confidence_training {
namespace {

TEST_CASE("right and wrong surfaces of a scene are told, with finite terms", "[confidence]") {
  const auto observations =
      observe(scoring::frame_of(scene::make_scene({scene::Family::kHard, 1000})));
  const auto right = std::count_if(observations.begin(), observations.end(),
                                   [](const Observation& o) { return o.right; });
  CHECK(right >= 3);
  CHECK(static_cast<std::size_t>(right) < observations.size());
  for (const Observation& o : observations) {
    CHECK(o.terms[0] == 1.0);
    CHECK(o.log_prior <= 0.0);
    for (const double term : o.terms) CHECK(std::isfinite(term));
  }
}

TEST_CASE("a cloud of which nothing can be made has no observations", "[confidence][degenerate]") {
  CHECK(observe(scoring::Frame()).empty());
}

}  // namespace
}  // namespace quadrille::confidence_training

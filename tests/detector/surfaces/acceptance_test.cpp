#include "surfaces/acceptance.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("a coarse level asks for more than the finest one", "[acceptance]") {
  const AggregateOptions options;
  const Acceptance coarse = acceptance_at(SearchLevel::kCoarse, options);
  const Acceptance finest = acceptance_at(SearchLevel::kFinest, options);
  CHECK(coarse.min_confidence == options.min_confidence_early);
  CHECK(finest.min_confidence == options.min_confidence);
  CHECK(coarse.min_candidate_confidence > finest.min_candidate_confidence);
  CHECK(coarse.max_candidate_residual == options.max_residual_early);
  CHECK(coarse.max_candidate_residual < finest.max_candidate_residual);
  CHECK(coarse.max_residual == finest.max_residual);
  CHECK_FALSE(coarse.takes_planes_instead);
  CHECK(finest.takes_planes_instead);
}

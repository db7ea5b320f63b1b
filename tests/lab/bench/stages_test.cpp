#include "lab/bench/stages.hpp"

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::bench {
namespace {

scoring::Frame easy_frame() {
  return scoring::frame_of(scene::make_scene({scene::Family::kEasy, 1000}));
}

int sum_of(const StageCounts& c) {
  return c.no_hypothesis + c.claimed + c.first_look + c.fit + c.confidence + c.accepted;
}

TEST_CASE("each surface of an easy scene goes through all stages", "[bench][stages]") {
  const StageCounts counts = follow_stages(easy_frame(), {});
  CHECK(counts.family == "easy");
  CHECK(counts.scenes == 1);
  CHECK(counts.wanted > 0);
  CHECK(sum_of(counts) == counts.wanted);
  CHECK(counts.accepted == counts.wanted);
  CHECK(counts.detected == counts.wanted);
}

TEST_CASE("what is hardly seen is not followed", "[bench][stages]") {
  const StageCounts counts = follow_stages(test::make_known_frame(), {});
  CHECK(counts.wanted == 1);
  CHECK(sum_of(counts) == 1);
}

TEST_CASE("the stage that asks too much loses all surfaces", "[bench][stages]") {
  const scoring::Frame frame = easy_frame();
  DetectorOptions options;
  SECTION("the search") {
    options.search.grow.min_samples = 1'000'000;
    options.search.axes = 0;
    const StageCounts counts = follow_stages(frame, options);
    CHECK(counts.no_hypothesis == counts.wanted);
  }
  SECTION("the samples that are open") {
    options.aggregate.min_samples = 1'000'000;
    const StageCounts counts = follow_stages(frame, options);
    CHECK(counts.claimed == counts.wanted);
  }
  SECTION("the fit, where the finest level refuses all at the first look") {
    options.aggregate.min_confidence_early = 0.0;
    options.aggregate.max_residual_early = 1e-3;
    options.aggregate.min_first_look = 1.0;
    const StageCounts counts = follow_stages(frame, options);
    CHECK(counts.fit == counts.wanted);
  }
  SECTION("the confidence") {
    options.aggregate.min_first_look = 0.0;
    options.aggregate.min_confidence = 1.0;
    options.aggregate.min_confidence_early = 1.0;
    const StageCounts counts = follow_stages(frame, options);
    CHECK(counts.confidence == counts.wanted);
    CHECK(counts.detected == 0);
    CHECK(counts.wrong == 0);
  }
}

TEST_CASE("the counts of a family's scenes add up", "[bench][stages]") {
  FrameOptions frames;
  frames.families = {scene::Family::kEasy, scene::Family::kHard};
  frames.scenes = 2;
  const std::vector<StageCounts> families = count_stages(frames);
  REQUIRE(families.size() == 2);
  CHECK(families[0].family == "easy");
  CHECK(families[1].family == "hard");
  for (const StageCounts& counts : families) {
    CHECK(counts.scenes == 2);
    CHECK(sum_of(counts) == counts.wanted);
  }
  CHECK(families[0].wanted >= follow_stages(easy_frame(), {}).wanted);
  CHECK(families[1].wanted > families[0].wanted);
}

TEST_CASE("a frame without points has nothing to follow", "[bench][stages][degenerate]") {
  const StageCounts counts = follow_stages(scoring::Frame(), {});
  CHECK(counts.scenes == 1);
  CHECK(counts.wanted == 0);
  CHECK(sum_of(counts) == 0);
}

}  // namespace
}  // namespace quadrille::bench

#include "lab/trials/judged_trials.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::trials {
namespace {

TEST_CASE("the trials of a ball before a wall find the ball, by its number", "[trials]") {
  const std::vector<JudgedTrial> trials = judged_trials(test::make_known_frame(), {});
  CHECK(std::any_of(trials.begin(), trials.end(), [](const JudgedTrial& t) {
    return t.of_candidate.verdict == scoring::Verdict::kRight && t.of_candidate.surface == 0;
  }));
  for (const JudgedTrial& t : trials) {
    CHECK(t.of_surface.has_value() == t.trial.surface.has_value());
    CHECK(!t.candidate.region.empty());
  }
}

TEST_CASE("judgements belong to the quadrics of their trial", "[trials]") {
  const scoring::Frame frame = scoring::frame_of(scene::make_scene({scene::Family::kHard, 1000}));
  const std::vector<JudgedTrial> trials = judged_trials(frame, {});
  REQUIRE(trials.size() > 3);
  for (const JudgedTrial& t : {trials.front(), trials.back()}) {
    const scoring::Judgement alone = scoring::judge_each(frame, {t.candidate.Q})[0];
    CHECK(t.of_candidate.verdict == alone.verdict);
    CHECK(t.of_candidate.surface == alone.surface);
    if (!t.trial.surface) continue;
    CHECK(t.of_surface->verdict == scoring::judge_each(frame, {t.trial.surface->Q})[0].verdict);
  }
  const auto at = [&](SearchLevel level) {
    return std::count_if(trials.begin(), trials.end(),
                         [&](const JudgedTrial& t) { return t.level == level; });
  };
  CHECK(at(SearchLevel::kCoarse) > 0);
  CHECK(at(SearchLevel::kFinest) > 0);
}

TEST_CASE("a cloud of which nothing can be made has no trials", "[trials][degenerate]") {
  CHECK(judged_trials(scoring::Frame(), {}).empty());
}

}  // namespace
}  // namespace quadrille::trials

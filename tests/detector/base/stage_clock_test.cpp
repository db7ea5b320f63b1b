#include "base/stage_clock.hpp"

#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("stages are listed in the order of their first end, each once", "[stage_clock]") {
  StageClock clock;
  CHECK(clock.timings().empty());
  for (const char* stage : {"search", "aggregate", "search", "measure"}) clock.end(stage);
  REQUIRE(clock.timings().size() == 3);
  CHECK(clock.timings()[0].stage == "search");
  CHECK(clock.timings()[1].stage == "aggregate");
  CHECK(clock.timings()[2].stage == "measure");
}

TEST_CASE("the times of a clock add up to no more than its total", "[stage_clock]") {
  StageClock clock;
  double sum = 0.0;
  for (const char* stage : {"a", "b", "a"}) clock.end(stage);
  for (const StageTime& time : clock.timings()) {
    CHECK(time.ms >= 0.0);
    sum += time.ms;
  }
  CHECK(sum <= clock.total_ms());
}

TEST_CASE("whoever watches is told each end of a stage", "[stage_clock]") {
  std::vector<std::string> ended;
  StageClock clock([&](std::string_view stage) { ended.emplace_back(stage); });
  const std::vector<std::string> stages = {"search", "aggregate", "search"};
  for (const std::string& stage : stages) clock.end(stage);
  CHECK(ended == stages);
  CHECK(clock.timings().size() == 2);
}

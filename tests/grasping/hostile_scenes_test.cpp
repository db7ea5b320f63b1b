// The inputs in tests/corpus/plan, which reach all that the fuzzer has reached.
#include "grasping/fuzz/plan_hostile.hpp"
#include "support/catch.hpp"
#include "support/corpus.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("hostile clouds and detections give sound plans, some of them with grasps",
          "[plan][hostile]") {
  std::size_t with_grasps = 0, refused = 0;
  for (const CorpusFile& file : read_corpus("plan")) {
    CAPTURE(file.name);
    Choices choices(file.bytes);
    GraspPlan plan;
    CHECK_NOTHROW(plan = plan_hostile(choices));
    with_grasps += !plan.grasps.empty();
    refused += !plan.rejected.empty();
  }
  CHECK(with_grasps > 0);
  CHECK(refused > 0);
}

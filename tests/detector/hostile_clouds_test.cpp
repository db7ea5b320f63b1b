// The inputs in tests/corpus/detect, which reach all that the fuzzer has reached.
#include "detector/fuzz/detect_hostile.hpp"
#include "support/catch.hpp"
#include "support/corpus.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("hostile clouds give sound results, some of them with surfaces", "[detector][hostile]") {
  std::size_t with_curved = 0, with_boxes = 0, warned = 0;
  for (const CorpusFile& file : read_corpus("detect")) {
    CAPTURE(file.name);
    Choices choices(file.bytes);
    DetectionResult result;
    CHECK_NOTHROW(result = detect_hostile(choices));
    with_curved += std::any_of(result.detections.begin(), result.detections.end(),
                               [](const Detection& d) { return !is_flat(d.type); });
    with_boxes += !result.boxes.empty();
    warned += !result.warnings.empty();
  }
  CHECK(with_curved > 0);
  CHECK(with_boxes > 0);
  CHECK(warned > 0);
}

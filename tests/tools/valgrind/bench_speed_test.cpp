#include <nlohmann/json.hpp>
#include <string>

#include "support/catch.hpp"
#include "support/scans.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::ordered_json;
using test::contains;
using test::Run;
using test::run_quadrille;

namespace {

/// The instructions of all stages together of the only cloud.
double sum_of(const ordered_json& baseline) {
  double sum = 0.0;
  for (const ordered_json& count : (*baseline["clouds"].begin())["instructions"]) {
    sum += count.get<double>();
  }
  return sum;
}

}  // namespace

TEST_CASE("a detector that takes more instructions than before is noticed", "[command][bench]") {
  const test::TempFolder folder;
  const std::string stored = folder.path("stored.json");
  const std::string speed = "bench --speed '" + (test::scans_folder() / "mug.pcd").string() + "'";
  const Run first = run_quadrille(speed + " --store " + stored);
  INFO(first.err);
  REQUIRE(first.code == 0);
  CHECK(contains(first.err, "is compared with nothing: the baseline does not know"));
  for (const char* stage : {"cells", "planes", "samples", "search", "aggregate", "measure", "boxes",
                            "bodies", "viewpoint", "all"}) {
    CHECK(contains(first.out, std::string("| ") + stage + " | "));
  }
  ordered_json before = ordered_json::parse(test::content_of(stored));
  CHECK(sum_of(before) > 1e7);

  // A baseline that is a tenth lower stands for a detector that has become slower.
  for (ordered_json& count : (*before["clouds"].begin())["instructions"]) {
    count = static_cast<long>(0.9 * count.get<double>());
  }
  const Run slower =
      run_quadrille(speed + " --baseline " + folder.write("less.json", before.dump()));
  CHECK(slower.code == 1);
  CHECK(contains(slower.out, " | +11."));
  CHECK(contains(slower.err, "takes 11."));

  before["built_by"] = "GNU 4.8.1";
  const Run other =
      run_quadrille(speed + " --baseline " + folder.write("other.json", before.dump()));
  CHECK(other.code == 0);
  CHECK(contains(other.err, "is of another build (GNU 4.8.1)"));
}

TEST_CASE("what the speed cannot be compared with is said at once", "[command][bench][hostile]") {
  const test::TempFolder folder;
  const std::string none = folder.write("none.json", "{}");
  test::check_failure(run_quadrille("bench --speed --baseline " + none),
                      "none.json: no counts of instructions");
  test::check_failure(run_quadrille("bench --speed --baseline " + folder.path("no.json")),
                      "no.json");
  test::check_failure(run_quadrille("bench --speed " + folder.path("no.ply")), "no.ply");
  for (const std::string option : {"--contender quadrille", "--stages", "--list", "--out ."}) {
    CHECK(run_quadrille("bench --speed " + option).code == 2);
  }
  CHECK(run_quadrille("bench --baseline " + none).code == 2);
  CHECK(run_quadrille("bench --store " + none).code == 2);
}

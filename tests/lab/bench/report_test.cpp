#include "lab/bench/report.hpp"

#include <nlohmann/json.hpp>

#include "support/catch.hpp"

namespace quadrille::bench {
namespace {

Row row_of(const std::string& contender, const std::string& counted, bool finds_others) {
  Row row;
  row.family = "easy";
  row.contender = contender;
  row.counted = counted;
  row.finds_others = finds_others;
  row.frames = 2;
  row.total.wanted = 4;
  row.total.found = 3;
  row.total.wrong = 1;
  row.total.width_errors = {0.01, 0.02, 0.5};
  row.total.widths_right = 2;
  row.total.distances = {0.0003, 0.00125, 0.02};
  row.wall_ms = {10.0, 20.0, 30.0};
  row.cpu_ms = {8.0, 9.0, 10.0};
  return row;
}

TEST_CASE("a row tells its shares and medians", "[bench][report]") {
  const auto json = to_json({row_of("one", "", false)})[0];
  CHECK(json["counted"] == "all");
  CHECK(json["recall"] == 0.75);
  CHECK(json["precision"] == 0.75);
  CHECK(json["wrong"] == 1);
  CHECK(json["right_width"].get<double>() == Approx(2.0 / 3.0));
  CHECK(json["width_error"] == 0.02);
  CHECK(json["distance"] == 0.00125);
  CHECK(json["wall_ms"] == 20.0);
  // There were no planes.
  CHECK(json["plane_recall"].is_null());
  const std::string table = to_markdown(to_table({row_of("one", "", false)}));
  CHECK(
      table.find(
          "| easy | all | one | 2 | 4 | 75.0 | 75.0 | 66.7 | 2.0 | 1.25 | - | - | 20.0 | 9.0 |") !=
      std::string::npos);
}

TEST_CASE("the table of stages has its counts in the order of the stages", "[bench][report]") {
  StageCounts counts;
  counts.family = "stereo kitchen";
  counts.scenes = 8, counts.wanted = 21;
  counts.no_hypothesis = 1, counts.claimed = 2, counts.first_look = 3;
  counts.fit = 4, counts.confidence = 5, counts.accepted = 6;
  counts.detected = 7, counts.wrong = 9;
  const std::string table = to_markdown(to_table(std::vector{counts}));
  CHECK(table.find("| stereo kitchen | 8 | 21 | 1 | 2 | 3 | 4 | 5 | 6 | 7 | 9 |") !=
        std::string::npos);
}

TEST_CASE("the table of stability has a row for seeds and shifts of each cloud, and the total",
          "[bench][report]") {
  Stability cloud;
  cloud.cloud = "a.ply";
  cloud.seeds.in_any = 4, cloud.seeds.in_all = 3, cloud.seeds.same_type = 2;
  cloud.seeds.sure_in_any = 2, cloud.seeds.sure_in_all = 1;
  const std::string one = to_markdown(to_table(std::vector{cloud}));
  CHECK(one.find("| a.ply | seed | 3 / 4 | 0.75 | 0.67 | 1 / 2 | 0.50 |") != std::string::npos);
  CHECK(one.find("| a.ply | shift | 0 / 0 | - | - | 0 / 0 | - |") != std::string::npos);
  CHECK(one.find("total") == std::string::npos);
  const std::string two = to_markdown(to_table(std::vector{cloud, cloud}));
  CHECK(two.find("| total | seed | 6 / 8 | 0.75 | 0.67 | 2 / 4 | 0.50 |") != std::string::npos);
}

TEST_CASE("who also finds what is not counted has no precision", "[bench][report]") {
  const auto json = to_json({row_of("all", "sphere", true)})[0];
  CHECK(json["precision"].is_null());
  CHECK(json["wrong"].is_null());
  CHECK(json["recall"] == 0.75);
  const std::string table = to_markdown(to_table({row_of("all", "sphere", true)}));
  CHECK(table.find("| 4 | 75.0 | - |") != std::string::npos);
}

TEST_CASE("rows of one family and count share a plot, and such without surfaces have none",
          "[bench][report]") {
  Row empty = row_of("three", "sphere", true);
  empty.total.wanted = empty.total.found = 0;
  const auto plots = plots_of(
      {row_of("one", "", false), row_of("two", "", false), row_of("one", "sphere", true), empty});
  REQUIRE(plots.size() == 2);
  CHECK(plots[0].lines.size() == 2);
  CHECK(plots[1].lines.size() == 1);
  CHECK(plots[1].title == "easy, spheres alone");
}

TEST_CASE("the page names the command, the version and who was absent", "[bench][report]") {
  const Contender absent{"cgal", "Efficient RANSAC", "", "not built", {}};
  const std::string page =
      to_markdown({row_of("one", "", false)}, {absent}, "quadrille bench --scenes 2", "9.8");
  CHECK(page.find("quadrille 9.8: `quadrille bench --scenes 2`") != std::string::npos);
  CHECK(page.find("- `cgal`: Efficient RANSAC (not built)") != std::string::npos);
}

}  // namespace
}  // namespace quadrille::bench

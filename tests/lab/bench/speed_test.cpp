#include "lab/bench/speed.hpp"

#include <cmath>

#include "io/file_bytes.hpp"
#include "lab/bench/report.hpp"
#include "lab/bench/speed_summary.hpp"
#include "support/catch.hpp"

namespace quadrille::bench {
namespace {

/// A cloud of 1,000 points with two stages, of which the second takes this many instructions.
CloudSpeed cloud_of(const std::string& set, const std::string& name, std::uint64_t search) {
  CloudSpeed cloud;
  cloud.set = set;
  cloud.name = name;
  cloud.points = 1000;
  cloud.stages = {{"cells", 2.0}, {"search", 4.0}};
  cloud.total_ms = 6.5;
  cloud.points_ms = 0.5;
  cloud.samples_ms = 0.1;
  cloud.cgal_ms = 65.0;
  cloud.counts = {{std::string(kReading), 7},
                  {"cells", 2'000'000},
                  {"search", search},
                  {std::string(kPassOverPoints), 500'000},
                  {std::string(kPassOverSamples), 100'000}};
  return cloud;
}

const std::string kBuild = "GNU 12.2.0, AVX2";

/// Two clouds, of 10 million instructions each.
const std::vector<CloudSpeed> kBefore = {cloud_of("medium", "medium 1", 8'000'000),
                                         cloud_of("medium", "medium 2", 8'000'000)};

SpeedSet compared(const std::vector<CloudSpeed>& now) {
  const std::vector<SpeedSet> sets = summarise(now, baseline_of(kBefore, kBuild), kBuild);
  REQUIRE(sets.size() == 1);
  return sets[0];
}

std::string why_not(const std::vector<CloudSpeed>& now, const std::string& built_by) {
  const std::vector<SpeedSet> sets = summarise(now, baseline_of(kBefore, kBuild), built_by);
  CHECK_FALSE(sets[0].is_too_slow());
  CHECK(std::isnan(sets[0].total.change()));
  return sets[0].not_compared;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("the clouds of a set are averaged by stage", "[bench][speed]") {
  const SpeedSet set = compared(
      {cloud_of("medium", "medium 1", 8'000'000), cloud_of("medium", "medium 2", 9'000'000)});
  CHECK(set.clouds == 2);
  REQUIRE(set.stages.size() == 2);
  CHECK(set.stages[0].ms == 2.0);
  CHECK(set.stages[0].floor_ms == 0.5);
  CHECK(set.stages[0].floor_instructions == 5e5);
  CHECK(set.stages[1].floor_ms == 0.1);
  CHECK(set.stages[1].instructions == 8.5e6);
  CHECK(set.stages[1].stored == 8e6);
  CHECK(set.stages[1].change() == Approx(0.0625));
  CHECK(set.total.ms == 6.5);
  CHECK(set.total.floor_ms == Approx(0.6));
  CHECK(set.total.instructions == 10.5e6);
  CHECK(set.total.change() == Approx(0.05));
  CHECK(set.cgal_ms == 65.0);
}

TEST_CASE("more than 3 % of instructions beyond the baseline are too many", "[bench][speed]") {
  const auto is_too_slow = [](std::uint64_t first, std::uint64_t second) {
    return compared({cloud_of("medium", "medium 1", first), cloud_of("medium", "medium 2", second)})
        .is_too_slow();
  };
  CHECK_FALSE(is_too_slow(8'000'000, 8'000'000));
  CHECK_FALSE(is_too_slow(8'500'000, 8'000'000));
  CHECK(is_too_slow(8'700'000, 8'000'000));
  CHECK_FALSE(is_too_slow(4'000'000, 4'000'000));
}

TEST_CASE("counts of another build, of other clouds, or none, are not compared", "[bench][speed]") {
  std::vector<CloudSpeed> now = {cloud_of("medium", "medium 1", 90'000'000)};
  CHECK(compared(now).is_too_slow());
  CHECK(why_not(now, "GNU 13.1.0, AVX2") ==
        "the baseline is of another build (GNU 12.2.0, AVX2) than this (GNU 13.1.0, AVX2)");
  now[0].points = 1001;
  CHECK(contains(why_not(now, kBuild), "another medium 1, of 1000 points"));
  now.push_back(cloud_of("medium", "medium 3", 8'000'000));
  now[0].points = 1000;
  CHECK(contains(why_not(now, kBuild), "does not know medium 3"));
  now[1].counts.clear();
  CHECK(contains(why_not(now, kBuild), "no instructions were counted"));
}

TEST_CASE("a baseline is the same once it was written and read", "[bench][speed]") {
  const SpeedBaseline baseline = baseline_of(kBefore, kBuild);
  const SpeedBaseline again = parse_baseline(to_json(baseline), "a.json");
  CHECK(again.built_by == kBuild);
  REQUIRE(again.clouds.size() == 2);
  CHECK(again.clouds.at("medium 1").points == 1000);
  CHECK(again.clouds.at("medium 2").stages == baseline.clouds.at("medium 2").stages);
  for (const char* text : {"", "{}", "[]", R"({"built_by": "a", "clouds": {"b": 3}})"}) {
    CHECK_THROWS_AS(parse_baseline(text, "a.json"), io::FileError);
  }
}

TEST_CASE("the baseline of the program is that of generated scenes", "[bench][speed]") {
  CHECK(own_baseline().clouds.count("medium 1000") == 1);
  CHECK_FALSE(built_by().empty());
}

TEST_CASE("the table has a row for each stage, for all together, and for CGAL", "[bench][speed]") {
  std::vector<CloudSpeed> now = {cloud_of("medium", "medium 1", 8'800'000)};
  const experiments::Table table = to_table(std::vector<SpeedSet>{compared(now)});
  REQUIRE(table.rows.size() == 5);
  CHECK(table.rows[1] ==
        std::vector<std::string>{"medium", "search", "4.0", "0.10", "8.8", "0.1", "8.0", "+10.0"});
  CHECK(table.rows[2][1] == "all");
  CHECK(table.rows[2][7] == "+8.0");
  CHECK(table.rows[3][2] == "65.0");
  CHECK(table.rows[4][2] == "10.0");
  now[0].counts.clear();
  now[0].cgal_ms = std::nan("");
  const experiments::Table bare = to_table(std::vector<SpeedSet>{compared(now)});
  REQUIRE(bare.rows.size() == 3);
  CHECK(bare.rows[1] ==
        std::vector<std::string>{"medium", "search", "4.0", "0.10", "-", "-", "-", "-"});
}

}  // namespace
}  // namespace quadrille::bench

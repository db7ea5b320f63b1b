#include "lab/study/summary.hpp"

#include "lab/study/study_files.hpp"
#include "lab/study/tables.hpp"
#include "lcmtypes/contains.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace quadrille;
using namespace quadrille::study;
using test::TempFolder;

namespace {

/// A table of the scenes from `begin` to before `end`, the last without a truth.
std::string table_of(const TempFolder& folder, const std::string& file, const char* gripper,
                     int begin, int end) {
  const Label label = test::label_with(gripper);
  std::vector<SceneName> names = test::names_of(end);
  names.erase(names.begin(), names.begin() + begin);
  StudyFiles files(folder.path(file), label, names);
  for (const SceneName& name : names) {
    SceneRecord record = test::typical_scene();
    if (name.number == end) {
      record.objects.reset();
      for (GraspRecord& grasp : record.grasps) {
        grasp.verdict.reset();
        grasp.attempt.reset();
      }
    }
    files.append(grasp_rows(label, name, record), scene_row(label, name, record));
  }
  return folder.path(file);
}

void check(const Ratio& ratio, int counted, int of) {
  CHECK(ratio.counted == counted);
  CHECK(ratio.of == of);
}

}  // namespace

TEST_CASE("a summary counts what was counted by hand", "[study]") {
  const TempFolder folder;
  const auto groups = summarise({table_of(folder, "a.csv", "franka", 0, 4)});
  REQUIRE(groups.size() == 1);
  const GroupSummary& group = groups.front();
  CHECK(group.name == "franka, unknown weighed, tabletop");
  CHECK(group.scenes == 4);
  CHECK(group.without_truth == 1);
  CHECK(group.grasps == 12);
  // Three scenes with a truth, each with 4 objects and 3 grasps, of which 2 are first ones.
  check(group.objects_with_grasp, 6, 12);
  check(group.objects_with_good, 3, 12);
  check(group.objects_with_held, 3, 12);
  check(group.first_good, 3, 6);
  check(group.first_touching, 3, 6);
  check(group.first_held, 3, 6);
  check(group.all_good, 6, 9);
  check(group.all_touching, 3, 9);
  check(group.all_held, 3, 6);
  const std::string text = summary_text(groups);
  // By hand: Wilson's interval of 6 of 12 is 0.5 ± 0.2462, of 6 of 9 it is .3542 to .8794.
  CHECK_THAT(text, test::contains("objects with a grasp                 6 of    12   50.0 %  "
                                  "(25.4 to 74.6 %)"));
  CHECK_THAT(text, test::contains("all grasps good                      6 of     9   66.7 %  "
                                  "(35.4 to 87.9 %)"));
  CHECK_THAT(text, test::contains("- on sphere held                     3 of     6   50.0 %"));
}

TEST_CASE("tables of shards add up, and grippers stay apart", "[study]") {
  const TempFolder folder;
  const std::string whole = table_of(folder, "whole.csv", "franka", 0, 4);
  const std::string a = table_of(folder, "a.csv", "franka", 0, 2),
                    b = table_of(folder, "b.csv", "franka", 2, 4),
                    other = table_of(folder, "c.csv", "wsg50", 0, 4);
  const auto two = summarise({a, b, scenes_path(b), other});
  REQUIRE(two.size() == 2);
  CHECK(two[0].scenes == 4);
  CHECK(two[0].grasps == 12);
  CHECK(two[1].name == "wsg50, unknown weighed, tabletop");
  CHECK_THROWS_WITH(summarise({whole, a}), test::contains("scene 1 (tabletop 11) is in"));
  CHECK_THROWS_WITH(summarise({folder.path("none.csv")}), test::contains("none.scenes.csv"));
}

TEST_CASE("the plot shows the share of first grasps from each score on", "[study]") {
  const TempFolder folder;
  const auto plots = score_plots(summarise({table_of(folder, "a.csv", "franka", 0, 4)}));
  REQUIRE(plots.size() == 2);
  REQUIRE(plots[1].lines.size() == 1);
  CHECK(plots[1].lines.front().name == "franka, weighed, tabletop");
  for (const auto& [least, share] : plots[1].lines.front().points) {
    // The dropped ones have .4, the held ones .9.
    CHECK(share == (least <= 0.4 ? 50.0 : 100.0));
    CHECK(least <= 0.9);
  }
}

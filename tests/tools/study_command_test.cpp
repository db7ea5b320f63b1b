#include <filesystem>
#include <set>
#include <sstream>

#include "support/catch.hpp"
#include "tools/support_files.hpp"
#include "tools/well_formed.hpp"

using namespace quadrille;
using test::check_failure;
using test::contains;
using test::content_of;
using test::Run;
using test::run_quadrille;
using test::TempFolder;

namespace {

const std::string kStudy = "study grasps --gripper franka --try none ";

Run study(const std::string& options, const std::string& csv) {
  return run_quadrille(kStudy + options + " --csv '" + csv + "'");
}

std::multiset<std::string> rows_of(const std::string& csv) {
  std::istringstream lines(content_of(csv));
  std::multiset<std::string> rows;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) rows.insert(line);
  return rows;
}

}  // namespace

TEST_CASE("a study of two scenes is the same in shards, resumed, and for any number of threads",
          "[study][command][determinism]") {
  const TempFolder folder;
  const std::string whole = folder.path("whole.csv"), more = folder.path("more.csv");
  const Run run = study("--scenes 2 --seed 3 --threads 1", whole);
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(contains(run.out, "franka, unknown weighed, tabletop (version "));
  CHECK(contains(run.out, "objects with a grasp"));
  CHECK(test::is_well_formed(content_of(folder.path("whole.svg"))));
  CHECK(rows_of(folder.path("whole.scenes.csv")).size() == 2);
  REQUIRE(study("--scenes 1 --seed 3", more).code == 0);
  const Run rest = study("--scenes 2 --seed 3 --threads 2", more);
  REQUIRE(rest.code == 0);
  CHECK(contains(rest.err, "1 of 2 scenes are there already"));
  CHECK(content_of(more) == content_of(whole));
  CHECK(content_of(folder.path("more.scenes.csv")) == content_of(folder.path("whole.scenes.csv")));
  for (const char* end : {".csv", ".scenes.csv"}) {
    std::multiset<std::string> merged;
    for (const char* shard : {"1", "2"}) {
      const std::string csv = folder.path(std::string("s").append(shard));
      REQUIRE(study(std::string("--scenes 2 --seed 3 --shard ").append(shard).append("/2"),
                    csv + ".csv")
                  .code == 0);
      merged.merge(rows_of(csv + end));
    }
    CHECK(merged == rows_of(std::string(whole, 0, whole.size() - 4) + end));
  }
  const Run sum = run_quadrille("study summary " + folder.path("s1.csv") + " " +
                                folder.path("s2.csv") + " " + folder.path("s2.scenes.csv"));
  CHECK(sum.code == 0);
  CHECK(run.out.starts_with(sum.out));
}

TEST_CASE("a study with other settings than those of its table is refused in one line",
          "[study][command][hostile]") {
  const TempFolder folder;
  const std::string csv = folder.path("a.csv");
  REQUIRE(study("--scenes 1 --seed 3", csv).code == 0);
  const std::string before = content_of(csv);
  check_failure(study("--scenes 1 --seed 4", csv), "is scene 1 (tabletop 3) where this run has");
  check_failure(study("--scenes 1 --seed 3 --unknown free", csv),
                "has unknown 'weighed' where this run has 'free'");
  check_failure(study("--scenes 1 --seed 3 --family easy", csv), "has family 'tabletop'");
  const std::string config = folder.write("c.toml", "[planner]\nresolution = 0.006\n");
  check_failure(study("--scenes 1 --seed 3 --config " + config, csv), "has other settings");
  CHECK(content_of(csv) == before);
}

TEST_CASE("clouds of files, folders and logs are studied like the scenes that they are of",
          "[study][command]") {
  const TempFolder folder;
  std::filesystem::create_directories(folder.path("in"));
  const std::string ply = folder.path("in/a.ply"), log = folder.path("b.lcm");
  REQUIRE(run_quadrille("scene --family tabletop --seed 3 " + ply).code == 0);
  REQUIRE(run_quadrille("log " + log + " " + ply + " " + ply).code == 0);
  const std::string bad = folder.write("in/z.ply", "ply\nformat ascii 1.0\n");
  const std::string given = folder.path("given.csv"), made = folder.path("made.csv");
  const Run run = study(folder.path("in") + " " + log, given);
  CHECK(run.code == 1);
  CHECK(contains(run.err, "1 of 4 clouds could not be used"));
  CHECK(contains(run.out, "2 scenes have no truth"));
  REQUIRE(study("--scenes 1 --seed 3", made).code == 0);
  // From the rank on a row says the same of the scene, be it made or read.
  const auto ranks = [](const std::string& text, const std::string& input) {
    std::multiset<std::string> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t at = line.find("," + input + ",");
      if (at != std::string::npos) rows.insert(line.substr(line.find(',', at + input.size() + 2)));
    }
    return rows;
  };
  const auto of_ply = ranks(content_of(given), ply);
  CHECK(of_ply.size() > 5);
  CHECK(of_ply == ranks(content_of(made), "tabletop 3"));
  CHECK(ranks(content_of(given), log + "#2").size() == of_ply.size());
  CHECK(contains(content_of(folder.path("given.scenes.csv")), "z.ply"));
  // What was done is not done again, in a log neither.
  CHECK(study(folder.path("in") + " " + log, given).code == 1);
  CHECK(rows_of(folder.path("given.scenes.csv")).size() == 4);
  check_failure(study(ply + " " + folder.path("in"), folder.path("c.csv")), "is given twice");
  check_failure(study(folder.path("none.ply"), folder.path("c.csv")), "no such file or folder");
}

TEST_CASE("wrong usage of a study is told", "[study][command][hostile]") {
  const TempFolder folder;
  const std::string csv = folder.path("a.csv");
  CHECK(run_quadrille("study").code == 2);
  CHECK(study("", csv).code == 2);
  CHECK(study("--scenes 1", folder.path("a.txt")).code == 2);
  CHECK(study("--scenes 1", folder.path("a.scenes.csv")).code == 2);
  CHECK(study("--scenes 1 a.ply", csv).code == 2);
  CHECK(study("--scenes 1 --viewpoint 0,0,1", csv).code == 2);
  for (const char* shard : {"0/2", "3/2", "1", "1/", "a/b", "1/2x"}) {
    CAPTURE(shard);
    const Run run = study(std::string("--scenes 1 --shard ").append(shard), csv);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "is no shard I/N"));
  }
  CHECK_FALSE(std::filesystem::exists(csv));
}

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "tools/support_files.hpp"
#include "tools/well_formed.hpp"

using namespace quadrille;
using nlohmann::json;
using test::contains;
using test::Run;
using test::run_quadrille;

namespace {

/// What the benchmark says of all surfaces, without the times.
json rows_of(const std::string& folder) {
  json rows = json::array();
  for (json row : json::parse(test::content_of(folder + "/bench.json"))) {
    CHECK(row["wall_ms"] > 0.0);
    CHECK(row["cpu_ms"] > 0.0);
    row.erase("wall_ms");
    row.erase("cpu_ms");
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_CASE("the benchmark has bins of cylinders", "[command][bench]") {
  const test::TempFolder folder;
  REQUIRE(
      run_quadrille("bench --scenes 1 --family bin --contender quadrille --out " + folder.path(""))
          .code == 0);
  const json row = rows_of(folder.path(""))[0];
  CHECK(row["family"] == "bin");
  CHECK(row["surfaces"] >= 10);
  CHECK(row["recall"] >= 0.7);
  CHECK(row["precision"] >= 0.9);
}

TEST_CASE("the benchmark writes one table in all forms, and a plot", "[command][bench]") {
  const test::TempFolder folder;
  const Run run = run_quadrille(
      "bench --scenes 2 --family easy,medium --contender quadrille,quadrille-sphere,plain-nine "
      "--out " +
      folder.path(""));
  INFO(run.err);
  REQUIRE(run.code == 0);
  const json rows = rows_of(folder.path(""));
  // Two families: all surfaces for two contenders, spheres for three.
  REQUIRE(rows.size() == 10);
  CHECK(rows[0]["family"] == "easy");
  CHECK(rows[0]["counted"] == "all");
  CHECK(rows[0]["contender"] == "quadrille");
  CHECK(rows[0]["frames"] == 2);
  CHECK(rows[0]["surfaces"] >= 2);
  CHECK(rows[0]["recall"] == 1.0);
  CHECK(rows[0]["precision"] > 0.5);
  CHECK(rows[9]["counted"] == "sphere");
  for (const json& row : rows) {
    const bool others = row["counted"] == "sphere" && row["contender"] != "quadrille-sphere";
    CHECK((row["precision"].is_null() && row["wrong"].is_null()) == others);
  }
  const std::string csv = test::content_of(folder.path("bench.csv"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 11);
  const std::string svg = test::content_of(folder.path("bench.svg"));
  CHECK(test::is_well_formed(svg));
  CHECK(contains(svg, "<use xlink:href='#gpPt6'"));
  const std::string page = test::content_of(folder.path("bench.md"));
  CHECK(contains(page, "--scenes 2 --seed 1000 --contender quadrille,quadrille-sphere,plain-nine"));
  CHECK(contains(page, "| medium | sphere | plain-nine |"));
  CHECK(contains(run.out, "| easy | all | quadrille |"));
}

TEST_CASE("superquadrics stand in the table, without planes", "[command][bench]") {
  const test::TempFolder folder;
  const Run run = run_quadrille(
      "bench --scenes 1 --family easy --contender quadrille,quadrille-objects,ems --out " +
      folder.path(""));
  INFO(run.err);
  REQUIRE(run.code == 0);
  const json rows = rows_of(folder.path(""));
  // All surfaces, and spheres.
  REQUIRE(rows.size() == 6);
  for (int i = 0; i < 3; ++i) {
    const bool given = i > 0;
    CHECK(rows[i]["contender"] == (i == 0 ? "quadrille" : i == 1 ? "quadrille-objects" : "ems"));
    CHECK(rows[i]["plane_recall"].is_null() == given);
    CHECK(rows[i]["surfaces"] == rows[0]["surfaces"]);
    CHECK(rows[i]["distance"] < 0.05);
  }
}

TEST_CASE("scenes from files are judged as scenes made at once", "[command][bench]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  REQUIRE(run_quadrille("scene --family medium --seed 1000 --labels " + cloud).code == 0);
  const std::string only = " --contender quadrille --out ";
  REQUIRE(run_quadrille("bench " + cloud + only + folder.path("files")).code == 0);
  REQUIRE(run_quadrille("bench --scenes 1 --family medium" + only + folder.path("made")).code == 0);
  CHECK(rows_of(folder.path("files")) == rows_of(folder.path("made")));
}

TEST_CASE("the benchmark tells at which stage surfaces are lost, and writes no files",
          "[command][bench]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  REQUIRE(run_quadrille("scene --family medium --seed 1000 --labels " + cloud).code == 0);
  const Run read = run_quadrille("bench --stages " + cloud);
  INFO(read.err);
  REQUIRE(read.code == 0);
  CHECK(contains(read.out, "| family | scenes | wanted | no hypothesis | claimed | first look |"));
  CHECK(contains(read.out, "| medium | 1 |"));
  CHECK(std::count(read.out.begin(), read.out.end(), '\n') == 3);
  CHECK(run_quadrille("bench --stages --scenes 1 --family medium").out == read.out);
  for (const std::string option : {"--contender quadrille", "--list", "--out ."}) {
    const Run run = run_quadrille("bench --stages " + option);
    INFO(run.err);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "excludes"));
  }
}

TEST_CASE("the benchmark tells how many surfaces all runs on a cloud find", "[command][bench]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  REQUIRE(run_quadrille("scene --family easy --seed 1000 " + cloud).code == 0);
  const Run run = run_quadrille("bench --stability " + cloud + " " + cloud);
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(contains(run.out, "| cloud | varied | in all / in any | share | of one type |"));
  CHECK(contains(run.out, "a.ply | seed |"));
  CHECK(contains(run.out, "a.ply | shift |"));
  CHECK(contains(run.out, "| total | shift |"));
  const Run without = run_quadrille("bench --stability");
  CHECK(without.code == 2);
  CHECK(contains(without.err, "requires"));
  CHECK(run_quadrille("bench --stability --stages " + cloud).code == 2);
  test::check_failure(run_quadrille("bench --stability " + folder.path("b.ply")), "b.ply");
}

TEST_CASE("the benchmark takes the detector's settings", "[command][bench]") {
  const test::TempFolder folder;
  const std::string scenes =
      "bench --scenes 1 --family medium --contender quadrille,quadrille-four ";
  const auto found_with = [&](const std::string& settings) {
    const std::string config = "--config " + folder.write("c.toml", settings);
    const Run run = run_quadrille(scenes + config + " --out " + folder.path("out"));
    INFO(run.err);
    REQUIRE(run.code == 0);
    CHECK(contains(test::content_of(folder.path("out/bench.md")), " " + config));
    json counts = json::array();
    for (const json& row : rows_of(folder.path("out"))) counts.push_back(row["found"]);
    return counts;
  };
  const json as_it_comes = found_with("");
  CHECK(as_it_comes == found_with("seed = 1\n"));
  // No surface has so many samples.
  for (const json& count : found_with("aggregate.min_samples = 1000000\n")) CHECK(count == 0);
  for (const char* wrong : {"search.base = 3\n", "only = [\"cone\"]\n"}) {
    const std::string config = folder.write("c.toml", wrong);
    test::check_failure(run_quadrille(scenes + "--config " + config), "c.toml");
  }
}

TEST_CASE("what the benchmark cannot use ends with one line", "[command][bench][hostile]") {
  const test::TempFolder folder;
  const std::string cloud = folder.path("a.ply");
  REQUIRE(run_quadrille("scene --family easy " + cloud).code == 0);
  const std::string only = " --contender quadrille --out " + folder.path("");
  test::check_failure(run_quadrille("bench " + cloud + only),
                      "a.labels: no such file; `quadrille scene --labels` makes");
  folder.write("scan.ply", test::content_of(cloud));
  test::check_failure(run_quadrille("bench " + folder.path("scan.ply") + only),
                      "scan.truth.json: no such file; `quadrille scene --labels` makes");
  for (const std::string option : {"--family easy", "--scenes 3", "--seed 4"}) {
    const Run run = run_quadrille("bench " + cloud + " " + option + only);
    INFO(run.err);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "CLOUD excludes " + option.substr(0, option.find(' '))));
  }
  folder.write("a.labels", "12");
  test::check_failure(run_quadrille("bench " + cloud + only), "not one entry per point");
  folder.write("a.truth.json", "{}");
  test::check_failure(run_quadrille("bench " + cloud + only), "no truth of a scene");
  CHECK(run_quadrille("bench --contender nobody").code == 2);
  CHECK(contains(run_quadrille("bench --list").out, "plain-nine"));
}

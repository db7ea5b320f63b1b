#include <filesystem>
#include <regex>

#include "lab/experiments/experiment.hpp"
#include "support/catch.hpp"
#include "support/environment_variable.hpp"
#include "tools/support_files.hpp"
#include "tools/well_formed.hpp"

using namespace quadrille;
using namespace quadrille::experiments;
using test::contains;
using test::EnvironmentVariable;
using test::run_quadrille;
using test::TempFolder;

TEST_CASE("without a name the command lists the experiments, and an unknown one is wrong usage",
          "[experiment][command]") {
  const auto list = run_quadrille("experiment");
  CHECK(list.code == 0);
  for (const Experiment& experiment : all_experiments()) {
    CHECK(contains("\n" + list.out, std::string("\n").append(experiment.name).append(" ")));
  }
  CHECK(test::lines_of(list.out) == static_cast<int>(all_experiments().size()));
  const auto unknown = run_quadrille("experiment nonsense");
  CHECK(unknown.code == 2);
  CHECK(test::lines_of(unknown.err) == 1);
  CHECK(contains(unknown.err, "'nonsense' is none of: fitting, minimal, lambda"));
}

TEST_CASE("an experiment writes a page, numbers and a plot, the same each time",
          "[experiment][command][determinism]") {
  const TempFolder folder;
  const std::string one = folder.path("one"), two = folder.path("a/two");
  const auto run = run_quadrille("experiment lambda --quick --seed 5 --out '" + one + "'");
  CHECK(run.code == 0);
  CHECK(run.err.empty());
  CHECK(run_quadrille("experiment lambda --quick --seed 5 --out '" + two + "'").code == 0);
  const std::string page = test::content_of(one + "/lambda.md");
  CHECK(contains(page, "`quadrille experiment lambda --seed 5 --quick`"));
  CHECK(test::content_of(one + "/lambda.csv").starts_with("voter,share,lambda"));
  CHECK(test::is_well_formed(test::content_of(one + "/lambda.svg")));
  for (const char* file : {"/lambda.md", "/lambda.csv", "/lambda.svg"}) {
    CHECK(test::content_of(one + file) == test::content_of(two + file));
  }
}

TEST_CASE("all experiments run by one command, and what is written stays where one has no data",
          "[experiment][command][slow]") {
  const TempFolder folder;
  const EnvironmentVariable data("QUADRILLE_DATA", folder.path("d"));
  const auto run = run_quadrille("experiment all --quick --out \"" + folder.path("it's") + "\"");
  // The last has no scans.
  CHECK(run.code == 1);
  // Beside how far it is, every ten seconds.
  const std::string error = std::regex_replace(run.err, std::regex("quadrille: .* % done.*\n"), "");
  CHECK(test::lines_of(error) == 1);
  CHECK(contains(error, "manifest.json: no real scans"));
  for (const Experiment& experiment : all_experiments()) {
    CAPTURE(experiment.name);
    const bool done = experiment.name != "sequence";
    CHECK(contains("\n" + run.out, "\n" + std::string(experiment.name) + ":\n") == done);
    const std::string file = folder.path("it's/" + std::string(experiment.name));
    for (const char* ending : {".md", ".csv"}) {
      CHECK(std::filesystem::exists(file + ending) == done);
    }
    // Not every experiment has plots.
    const bool plotted = std::filesystem::exists(file + ".gnuplot");
    CHECK(std::filesystem::exists(file + ".svg") == plotted);
    if (plotted) CHECK(test::is_well_formed(test::content_of(file + ".svg")));
  }
}

TEST_CASE("a folder that cannot be written to is named before any work",
          "[experiment][bench][command][hostile]") {
  const TempFolder folder;
  const std::string file = folder.write("file", "x");
  std::filesystem::create_directories(folder.path("lambda.md"));
  std::filesystem::create_directories(folder.path("bench.json"));
  for (const char* command : {"experiment lambda", "bench --contender plain-nine"}) {
    CAPTURE(command);
    const auto run = [&](const std::string& out) {
      return run_quadrille(std::string(command).append(" --out '" + out + "'"));
    };
    test::check_failure(run(file), "file: cannot be made a folder");
    test::check_failure(run(file + "/b"), "; give --out another one");
    test::check_failure(run(folder.path(std::string(300, 'x'))), "; give --out another one");
    test::check_failure(run(""), "--out: is empty; give a folder");
    // There even root makes no files.
    test::check_failure(run("/proc"), "; check the folder and its permissions");
    test::check_failure(run(folder.path("")), "cannot be created");
  }
}

TEST_CASE("an experiment's seed is a whole number from 0 on", "[experiment][command][hostile]") {
  for (const char* seed : {"-1", "99999999999999999999999", "1.5", "x"}) {
    const auto run = run_quadrille(std::string("experiment minimal --quick --seed ").append(seed));
    CAPTURE(seed);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "is no whole number from 0 to 18446744073709551615"));
  }
}

TEST_CASE("only the experiment of the printed pipeline takes settings, and refuses unknown ones",
          "[experiment][command][hostile]") {
  const TempFolder folder;
  const std::string file = folder.write("c.toml", "[printed]\npools = 3\n");
  const std::string rest = " --quick --config '" + file + "' --out '" + folder.path("o") + "'";
  test::check_failure(run_quadrille("experiment printed" + rest), "unknown key 'printed.pools'");
  for (const char* other : {"lambda", "all"}) {
    const auto run = run_quadrille(std::string("experiment ").append(other) + rest);
    CHECK(run.code == 2);
    CHECK(contains(run.err, "is only for the experiment printed"));
  }
  test::check_failure(
      run_quadrille("experiment printed --config /nowhere.toml --out '" + folder.path("o") + "'"),
      "/nowhere.toml");
}

TEST_CASE("a sequence without scans, or with a broken list of them, is a failure of one line",
          "[experiment][command][hostile]") {
  const TempFolder folder;
  const EnvironmentVariable data("QUADRILLE_DATA", folder.path("d"));
  std::filesystem::create_directories(folder.path("d/data/real"));
  const auto check = [&](const std::string& part) {
    const test::Run run = run_quadrille("experiment sequence --out '" + folder.path("o") + "'");
    test::check_failure(run, "d/data/real/manifest.json: ");
    test::check_failure(run, part);
    CHECK(std::filesystem::is_empty(folder.path("o")));
  };
  check("manifest.json: no real scans; set QUADRILLE_DATA to a folder with data/real");
  {
    const std::string name(300, 'x');
    const EnvironmentVariable too_long("QUADRILLE_DATA", folder.path(name));
    test::check_failure(run_quadrille("experiment sequence --out '" + folder.path("o") + "'"),
                        name + "/data/real/manifest.json: no real scans");
  }
  const std::string scan = R"({"scenes":[{"kind":"sequence","name":"b",)";
  const std::string radius = R"("radius_over_sequence":{"median":0.1},)";
  for (const std::string& text :
       {std::string("{}"), std::string("garbage"), std::string(""), std::string("[]"),
        std::string("{\"scenes\":[7]}"), scan + R"("frames":[]}]})",
        scan + radius + R"("frames":[{"file":"a.ply"}]}]})",
        scan + R"("radius_over_sequence":{"median":0},"frames":[]}]})",
        scan + radius + R"("frames":[{"file":"a.ply","objects":[]}]}]})",
        scan + radius + R"("frames":[{"file":"a.ply","objects":[{"params":{"center":[0,1]}}]}]}]})",
        scan + radius + R"("frames":[{"file":1,"objects":[{"params":{"center":[0,1,2]}}]}]}]})"}) {
    CAPTURE(text);
    folder.write("d/data/real/manifest.json", text);
    check("no list of scans: ");
  }
  for (const std::string& text :
       {std::string(R"({"scenes":[]})"), scan + radius + R"("frames":[]}]})"}) {
    folder.write("d/data/real/manifest.json", text);
    CAPTURE(text);
    check("manifest.json: lists no sequence; set QUADRILLE_DATA to a folder with data/real");
  }
}

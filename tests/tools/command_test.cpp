#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/scene/scene_files.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;
using test::check_failure;
using test::contains;
using test::lines_of;
using test::ply_of;
using test::Run;
using test::run_quadrille;
using test::TempFolder;

TEST_CASE("bad files end the command with 1 and one line", "[command][hostile]") {
  const TempFolder folder;
  check_failure(run_quadrille("detect " + folder.path("none.ply")), "none.ply: no such file");
  check_failure(run_quadrille("detect " + folder.path("none.pcd")), "none.pcd: no such file");
  check_failure(run_quadrille("detect /tmp"), "/tmp");
  check_failure(run_quadrille("detect " + folder.write("a.txt", "x")), "an LCM log");
  check_failure(run_quadrille("detect " + folder.write("text.ply", "hello\n")), "line 1");
  check_failure(run_quadrille("detect " + folder.write("empty.ply", "")), "line 1");
  check_failure(run_quadrille("detect " + folder.write("empty.pcd", "")), "DATA");
  std::string cut = ply_of({"1 2 3", "4 5 6"});
  cut.resize(cut.size() - 6);
  check_failure(run_quadrille("detect " + folder.write("cut.ply", cut)), "byte");
  check_failure(run_quadrille("plan --gripper franka " + folder.write("cut2.ply", cut)), "byte");
}

TEST_CASE("absurd counts are refused within little memory", "[command][hostile]") {
  const TempFolder folder;
  for (const char* count : {"4000000000", "18446744073709551615"}) {
    const std::string path = folder.write(
        "huge.ply", "ply\nformat binary_little_endian 1.0\nelement vertex " + std::string(count) +
                        "\nproperty float x\nproperty float y\nproperty float z\nend_header\nabc");
    check_failure(run_quadrille("detect " + path), "byte");
  }
  const std::string path = folder.write(
      "huge.pcd",
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2000000000\nHEIGHT 2000000000\n"
      "DATA binary\nabc");
  check_failure(run_quadrille("detect " + path), "byte");
}

TEST_CASE("degenerate clouds give an empty or sane result, never NaN", "[command][hostile]") {
  const TempFolder folder;
  const std::vector<std::string> line(200, "0.1 0.2 0.5");
  std::vector<std::string> on_a_line, millimetres;
  for (int i = 1; i <= 300; ++i) {
    on_a_line.push_back(std::to_string(0.001 * i) + " 0.1 0.5");
    millimetres.push_back(std::to_string(i % 20 * 10) + " " + std::to_string(i / 20 * 10) + " 900");
  }
  const std::vector<std::pair<std::string, std::vector<std::string>>> clouds = {
      {"none.ply", {}},
      {"one.ply", {"0.1 0.2 0.5"}},
      {"nan.ply", {"nan nan nan", "inf 0 1", "0 0 0", "-inf nan 2"}},
      {"same.ply", line},
      {"line.ply", on_a_line},
      {"millimetres.ply", millimetres}};
  for (const auto& [name, points] : clouds) {
    const Run run = run_quadrille("detect --json - " + folder.write(name, ply_of(points)));
    INFO(name << " " << run.err);
    REQUIRE(run.code == 0);
    const json result = json::parse(run.out);
    CHECK(result["points"]["read"] == points.size());
    CHECK_FALSE(contains(run.out, "null"));
    for (const json& d : result["detections"]) CHECK(d["type"] == "plane");
  }
  const Run run = run_quadrille("detect --json - " + folder.path("nan.ply"));
  CHECK(json::parse(run.out)["points"]["finite"] == 0);
}

TEST_CASE("wrong usage ends the command with 2", "[command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", ply_of({"1 2 3"}));
  for (const std::string& arguments : std::vector<std::string>{
           "", "nonsense", "detect", "detect --seed x " + cloud, "detect --threads 0 " + cloud,
           "detect --only " + cloud, "detect --nonsense " + cloud, "plan " + cloud,
           "plan --gripper no_such_hand " + cloud, "plan --gripper franka --unknown maybe " + cloud,
           "scene", "scene out.obj", "scene out.ply --family impossible"}) {
    const Run run = run_quadrille(arguments);
    INFO(arguments << "\n" << run.err);
    CHECK(run.code == 2);
    CHECK_FALSE(run.err.empty());
  }
  for (const std::string& arguments : std::vector<std::string>{
           "plan --gripper franka --unknown x " + cloud, "scene s.ply --family x",
           "log o.lcm --as x " + cloud, "plan --gripper franka --unknown 1 " + cloud,
           "scene s.ply --family 3", "detect --picture p.jpg " + cloud,
           "plan --gripper franka --picture p.png.txt " + cloud,
           "detect --picture p.png --picture-view below " + cloud}) {
    const Run run = run_quadrille(arguments);
    INFO(arguments << "\n" << run.err);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(lines_of(run.err) == 1);
    CHECK((contains(run.err, "is none of: ") || contains(run.err, "must end in .png")));
  }
  const Run family = run_quadrille("scene s.ply --family x");
  CHECK(contains(family.err, "--family: 'x' is none of: easy, medium, hard, tabletop; see"));
  const Run only = run_quadrille("detect --only sphere,cube " + cloud);
  CHECK(only.code == 2);
  CHECK(contains(only.err, "'cube'"));
  CHECK(contains(only.err, "elliptic_cylinder"));
  CHECK(contains(run_quadrille("nonsense").err,
                 "unknown command 'nonsense'; give one of the commands detect, plan"));
  CHECK(contains(run_quadrille("").err, "quadrille: give one of the commands detect, plan"));
  CHECK(contains(run_quadrille("plan " + cloud).err, "see quadrille plan --help"));
  CHECK(run_quadrille("--version").out.starts_with("quadrille "));
  CHECK(run_quadrille("--help").code == 0);
  CHECK(run_quadrille("detect --help").code == 0);
}

TEST_CASE("the settings of a search for spheres alone are printed, and are those it has",
          "[command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", ply_of({"1 2 3"}));
  const std::string config = folder.write("c.toml", "search.voters = 20\n");
  const auto settings_of = [&](const std::string& arguments) {
    return nlohmann::json::parse(run_quadrille("detect --json - " + arguments + " " + cloud).out)
        .at("settings");
  };
  const nlohmann::json used = settings_of("--only sphere --config " + config);
  CHECK(used["search.basis"] == "sphere");
  CHECK(used["search.voters"] == 20);
  CHECK(used["sampling.cell"] > 0.0043);
  const Run printed = run_quadrille("config --only sphere --config " + config);
  CHECK(settings_of("--config " + folder.write("d.toml", printed.out)) == used);
  CHECK_FALSE(settings_of("--only sphere,cone").contains("search.basis"));
}

TEST_CASE("seeds, rates and types that cannot be meant are wrong usage", "[command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", ply_of({"1 2 3"}));
  const auto check_usage = [](const std::string& arguments, const std::string& part) {
    const Run run = run_quadrille(arguments);
    INFO(arguments << "\n" << run.err);
    CHECK(run.code == 2);
    CHECK(lines_of(run.err) == 1);
    CHECK(contains(run.err, part));
  };
  for (const std::string seed : {"-1", "1.5", "1x", "99999999999999999999"}) {
    const std::string part = "'" + seed + "' is no whole number from 0 to 18446744073709551615";
    check_usage("detect --seed=" + seed + " " + cloud, part);
    check_usage("scene --seed=" + seed + " " + folder.path("s.ply"), part);
  }
  CHECK(run_quadrille("detect --seed 18446744073709551615 " + cloud).code == 0);
  for (const std::string rate : {"0", "-1", "1e9", "nan", "fast"}) {
    check_usage("log " + folder.path("o.lcm") + " " + cloud + " --rate=" + rate,
                "'" + rate + "' is no number from 0.001 to 10000; see");
  }
  CHECK_FALSE(contains(run_quadrille("log --help").out, "0.001000"));
  for (const std::string type : {"imaginary_cone", "coincident_planes"}) {
    check_usage("detect --only sphere," + type + " " + cloud,
                "type '" + type + "' is never found; the types are sphere, ellipsoid, cylinder");
  }
  CHECK_FALSE(contains(run_quadrille("detect --only cube " + cloud).err, "imaginary"));
}

TEST_CASE("a run that fails leaves outputs as they were", "[command][hostile]") {
  const TempFolder folder;
  const std::string good = folder.write("good.ply", ply_of({"1 2 3"}));
  const std::string missing = folder.path("missing.ply");
  const std::string out = folder.write("kept", "kept");
  for (const std::string& arguments : std::vector<std::string>{
           "log " + out + " " + good + " " + missing, "detect " + missing + " --json " + out,
           "plan --gripper franka " + missing + " --json " + out}) {
    check_failure(run_quadrille(arguments), "missing.ply: no such file");
    CHECK(test::content_of(out) == "kept");
  }
  check_failure(run_quadrille("log " + folder.path("new.lcm") + " " + good + " " + missing),
                "missing.ply");
  // Nothing is left beside them either.
  const auto files = std::filesystem::directory_iterator(std::filesystem::path(out).parent_path());
  CHECK(std::distance(begin(files), end(files)) == 2);
}

TEST_CASE("outputs go through links and into what is no regular file", "[command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", ply_of({"1 2 3"}));
  const std::string real = folder.write("real.json", "old");
  std::filesystem::create_symlink(real, folder.path("link.json"));
  REQUIRE(run_quadrille("detect " + cloud + " --json " + folder.path("link.json")).code == 0);
  CHECK(std::filesystem::is_symlink(folder.path("link.json")));
  CHECK(json::parse(test::content_of(real))["input"] == cloud);
  const Run null = run_quadrille("detect " + cloud + " --json /dev/null");
  INFO(null.err);
  CHECK(null.code == 0);
  CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("JSON goes to stdout alone, or to a file beside the table", "[command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", ply_of({"1 2 3", "nan 1 2", "4 5 6"}));
  const Run alone = run_quadrille("detect --json - " + cloud);
  CHECK(alone.code == 0);
  CHECK(lines_of(alone.out) == 1);
  CHECK(json::parse(alone.out)["points"]["finite"] == 2);
  const std::string file = folder.path("out.json");
  const Run beside = run_quadrille("detect --json " + file + " " + cloud);
  CHECK(contains(beside.out, "a.ply"));
  CHECK(json::parse(test::content_of(file))["input"] == cloud);
  check_failure(run_quadrille("detect --json " + folder.path("no/out.json") + " " + cloud),
                "cannot be created");
}

TEST_CASE("several inputs give one JSON object a line and a picture each", "[command]") {
  const TempFolder folder;
  const std::string a = folder.write("a.ply", ply_of({"0.1 0.2 1", "0.2 0.2 1"}));
  const std::string b = folder.write("b.ply", ply_of({"0.1 0.2 1", "0.3 0.2 1", "0 0.1 1"}));
  const Run run = run_quadrille("detect " + a + " " + b + " " + a + " --json - --picture " +
                                folder.path("p.png"));
  CHECK(run.code == 0);
  REQUIRE(lines_of(run.out) == 3);
  const std::string second = run.out.substr(run.out.find('\n') + 1);
  CHECK(json::parse(second.substr(0, second.find('\n')))["points"]["read"] == 3);
  for (const char* name : {"p_a.png", "p_b.png", "p_a_2.png"}) {
    CHECK(test::content_of(folder.path(name)).substr(1, 3) == "PNG");
  }
}

TEST_CASE("an input that cannot be read does not lose the others", "[command][hostile]") {
  const TempFolder folder;
  const std::string good = folder.write("a.ply", ply_of({"0.1 0.2 1", "0.2 0.2 1"}));
  const std::string bad = folder.write("b.ply", "no cloud");
  const std::string out = folder.write("out", "old");
  const Run one = run_quadrille("detect " + good + " " + bad + " " + good + " --json " + out);
  CHECK(one.code == 1);
  CHECK(contains(one.err, "b.ply: line 1: not a PLY file"));
  CHECK(lines_of(test::content_of(out)) == 2);
  const Run two = run_quadrille("detect " + bad + " " + good + " " + bad + " --json -");
  CHECK(two.code == 1);
  CHECK(contains(two.err, "2 of 3 inputs could not be read"));
  CHECK(lines_of(two.out) == 1);
  // What cannot be written is no fault of the inputs, and ends the command.
  const Run three = run_quadrille("detect " + good + " " + good + " --json - --picture " +
                                  folder.path("missing/p.png"));
  CHECK(three.code == 1);
  CHECK(contains(three.err, "p_a.png: cannot be created"));
  CHECK_FALSE(contains(three.err, "could not be read"));
  CHECK(lines_of(three.out) == 1);
  // Of none that can be read, nothing is written.
  CHECK(run_quadrille("detect " + bad + " " + bad + " --json " + out).code == 1);
  CHECK(lines_of(test::content_of(out)) == 2);
}

TEST_CASE("plan prints JSON with all parts for a cloud without objects", "[command]") {
  const TempFolder folder;
  const std::string cloud = folder.write("a.ply", ply_of({"1 2 3"}));
  for (const char* policy : {"weighed", "obstacle", "target-shadow", "free"}) {
    const Run run = run_quadrille("plan --gripper franka --json - --picture " +
                                  folder.path("p.png") + " --unknown " + policy + " " + cloud);
    INFO(run.err);
    REQUIRE(run.code == 0);
    CHECK(json::parse(run.out)["grasps"].empty());
    CHECK(std::filesystem::exists(folder.path("p.png")));
  }
}

TEST_CASE("view refuses two kinds of messages on one channel", "[command][usage]") {
  // The address is wrong too, so that nothing would be served.
  const Run run = run_quadrille("view --bind 256.0.0.1 --pose-channel POINT_CLOUD");
  CHECK(run.code == 2);
  CHECK(contains(run.err, "--pose-channel: 'POINT_CLOUD' is the channel of --cloud-channel too"));
}

TEST_CASE("scene writes the same cloud and truth for the same seed", "[command][determinism]") {
  const TempFolder folder;
  const std::string a = folder.path("a.ply"), b = folder.path("b.ply");
  REQUIRE(run_quadrille("scene --family tabletop --seed 9 " + a).code == 0);
  REQUIRE(run_quadrille("scene --family tabletop --seed 9 " + b).code == 0);
  CHECK(test::content_of(a) == test::content_of(b));
  const std::string truth = test::content_of(scene::truth_path(a));
  CHECK(truth == test::content_of(scene::truth_path(b)));
  CHECK(json::parse(truth)["family"] == "tabletop");
  const Run run = run_quadrille("detect --json - " + a);
  CHECK(json::parse(run.out)["points"]["read"] == json::parse(truth)["points"]);
  check_failure(run_quadrille("scene " + folder.path("no/such/s.ply")), "cannot be created");
}

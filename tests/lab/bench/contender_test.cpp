#include "lab/bench/contender.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "lab/bench/peer_program.hpp"
#include "lab/bench/plain_ransac.hpp"
#include "lcmtypes/contains.hpp"
#include "support/catch.hpp"
#include "support/known_frame.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::bench {
namespace {

const Contender& contender_named(const std::vector<Contender>& all, const std::string& name) {
  for (const Contender& contender : all) {
    if (contender.name == name) return contender;
  }
  FAIL("no contender " << name);
  return all.front();
}

FrameScore score_of(const Contender& contender, const Frame& frame) {
  const Outcome outcome = contender.run(frame);
  CHECK(outcome.wall_ms > 0.0);
  CHECK(outcome.cpu_ms > 0.0);
  return scoring::score(frame, outcome.findings, contender.only);
}

/// A peer's program that is a script.
std::string write_script(const test::TempFolder& folder, const std::string& text) {
  const std::string path = folder.write("quadrille-peer-cgal", "#!/bin/sh\n" + text);
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

TEST_CASE("quadrille, its variants and the baselines find a ball before a wall",
          "[bench][contender]") {
  const Frame frame = test::make_known_frame();
  const std::vector<Contender> all = all_contenders("/nowhere");
  for (const char* name :
       {"quadrille", "quadrille-two", "quadrille-four", "quadrille-nine", "quadrille-solved",
        "quadrille-measured", "quadrille-hashed", "quadrille-confident", "quadrille-clusters",
        "quadrille-agglomerate", "quadrille-sphere", "plain-nine", "plain-four"}) {
    INFO(name);
    const Contender& contender = contender_named(all, name);
    CHECK(contender.absent.empty());
    const FrameScore s = score_of(contender, frame);
    CHECK(s.found == 1);
    CHECK(s.widths_right == 1);
    if (contender.only.empty()) CHECK(s.planes_found == 1);
  }
}

TEST_CASE("fits to given objects find the balls, and are not judged on planes",
          "[bench][contender]") {
  const Frame frame = test::make_known_frame();
  const std::vector<Contender> all = all_contenders("/nowhere");
  for (const char* name : {"quadrille-objects", "ems"}) {
    INFO(name);
    const Contender& contender = contender_named(all, name);
    CHECK(contender.absent.empty());
    CHECK(contender.given_objects);
    const FrameScore s = score_of(contender, frame);
    CHECK(s.found == 1);
    CHECK(s.wrong == 0);
    CHECK(s.widths_right == 1);
    REQUIRE(s.distances.size() == 1);
    CHECK(s.distances[0] < 0.001);
  }
}

TEST_CASE("a peer that is not built is absent, with what mends it", "[bench][contender]") {
  const std::string absent = contender_named(all_contenders("/nowhere"), "cgal").absent;
  CHECK(absent.find("tools/setup --bench") != std::string::npos);
}

TEST_CASE("a peer's program gets the cloud and its family, and is heard", "[bench][contender]") {
  const test::TempFolder folder;
  write_script(folder,
               "head -c 3 \"$1\" | grep -q ply && [ \"$2\" = easy ] || exit 1\n"
               "echo '{\"wall_ms\": 5, \"cpu_ms\": 4, \"findings\":"
               " [{\"q\": [1,1,1,0,0,0,0,0,-1,0.99], \"score\": 2}]}' > \"$3\"\n");
  const std::vector<Contender> all = all_contenders(folder.path(""));
  const Contender& peer = contender_named(all, "cgal");
  REQUIRE(peer.absent.empty());
  const Frame frame = test::make_known_frame();
  const Outcome outcome = peer.run(frame);
  CHECK(outcome.wall_ms == 5.0);
  CHECK(outcome.cpu_ms == 4.0);
  CHECK(scoring::score(frame, outcome.findings).found == 1);
}

TEST_CASE("a peer's program that fails is named", "[bench][contender][hostile]") {
  const test::TempFolder folder;
  const std::string path = write_script(folder, "exit 3\n");
  CHECK_THROWS_WITH(run_program_on(path, test::make_known_frame()),
                    test::contains(path + ": failed"));
}

}  // namespace
}  // namespace quadrille::bench

#include <CLI/CLI.hpp>

#include "io/file_bytes.hpp"
#include "io/planner/gripper_file.hpp"
#include "process/planner/command_line.hpp"
#include "process/planner/status_text.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

PlannerSettings settings_of(const std::string& arguments) {
  CLI::App app;
  const PlannerCommandLine command_line(app);
  app.parse(arguments);
  return command_line.settings();
}

TEST_CASE("options of the command line win over the planner's configuration", "[planner]") {
  const test::TempFolder folder;
  const std::string config =
      "--config " +
      folder.write("p.toml", "seed = 3\n[planner]\nunknown = \"free\"\napproach = 0.08\n");
  CHECK(settings_of(config).plan.unknown == UnknownPolicy::kFree);
  const PlannerSettings settings = settings_of(config + " --unknown target-shadow");
  CHECK(settings.plan.unknown == UnknownPolicy::kTargetShadow);
  CHECK(settings.plan.approach == 0.08);
  CHECK(settings.gripper.name == "franka");
}

TEST_CASE("on the bus plans have a deadline, in replays they have none", "[planner][deadline]") {
  const test::TempFolder folder;
  const std::string log = "--in-log " + folder.write("in.lcm", "") + " --out-log out.lcm";
  CHECK(settings_of("").plan.deadline_ms == 500.0);
  CHECK(settings_of(log).plan.deadline_ms == 0.0);
  const std::string config =
      "--config " + folder.write("p.toml", "[planner]\ndeadline_ms = 80.0\n");
  CHECK(settings_of(config).plan.deadline_ms == 80.0);
  CHECK(settings_of(config + " " + log).plan.deadline_ms == 80.0);
  CHECK(settings_of(config + " --deadline-ms 0").plan.deadline_ms == 0.0);
  CHECK_THROWS_AS(settings_of("--deadline-ms -1"), CLI::ParseError);
}

TEST_CASE("the planner's process checks the whole file", "[planner]") {
  const test::TempFolder folder;
  CHECK_THROWS_AS(settings_of("--config " + folder.write("p.toml", "[planner]\nnonsense = 1\n")),
                  io::FileError);
  CHECK_THROWS_AS(settings_of("--config " + folder.write("q.toml", "[planes]\nsigmas = -1\n")),
                  io::FileError);
}

TEST_CASE("what nobody listens to can be left out, and planning gives way", "[planner]") {
  CHECK(settings_of("").shapes);
  CHECK(settings_of("").occupancy_period == 1.0);
  CHECK(settings_of("").process.niceness == 5);
  const PlannerSettings settings =
      settings_of("--no-shapes --no-occupancy --occupancy-period 0 --nice 0");
  CHECK_FALSE(settings.shapes);
  CHECK_FALSE(settings.occupancy);
  CHECK(settings.occupancy_period == 0.0);
  CHECK(settings.process.niceness == 0);
  CHECK_THROWS_AS(settings_of("--nice 20"), CLI::ParseError);
  CHECK_THROWS_AS(settings_of("--occupancy-period -1"), CLI::ParseError);
}

TEST_CASE("another hand, or another file of its name, gives the settings another hash",
          "[planner][status]") {
  const test::TempFolder folder;
  const std::string franka = io::gripper_toml("franka");
  std::string longer = franka;
  longer.replace(longer.find("tcp = 0.1034"), 12, "tcp = 0.1044");
  const std::string hash = hash_of(settings_of("--gripper franka"));
  const auto hash_of_file = [&](const std::string& text) {
    return hash_of(settings_of("--gripper " + folder.write("franka.toml", text)));
  };
  CHECK(hash_of_file(franka) == hash);
  CHECK(hash_of_file(longer) != hash);
  CHECK(hash_of(settings_of("--gripper wsg50")) != hash);
}

TEST_CASE("a gripper that is not known is wrong usage of the planner", "[planner]") {
  CHECK_THROWS_AS(settings_of("--gripper no_such_hand"), CLI::ParseError);
  CHECK_THROWS_AS(settings_of("--gripper none.toml"), io::FileError);
}

}  // namespace
}  // namespace quadrille

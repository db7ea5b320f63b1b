#include <CLI/CLI.hpp>

#include "command_line.hpp"
#include "config.hpp"
#include "io/file_bytes.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

PlannerSettings settings_of(const std::string& arguments) {
  CLI::App app;
  const CommandLine command_line(app);
  app.parse(arguments);
  return command_line.settings();
}

TEST_CASE("the planner's configuration sets what it names and leaves the rest", "[planner]") {
  const test::TempFolder folder;
  const PlanOptions options =
      load_plan_options(folder.write("p.toml",
                                     "unknown = \"free\"\nresolution = 0.004\nfriction = "
                                     "0.4\napproach = 0.08\npad_margin = 0.001\n"
                                     "baseline = 0\nwall_least = 0.001\nwall_most = 0.005\n"));
  CHECK(options.unknown == UnknownPolicy::kFree);
  CHECK(options.resolution == 0.004);
  CHECK(options.friction == 0.4);
  CHECK(options.approach == 0.08);
  CHECK(options.pad_margin == 0.001);
  CHECK(options.baseline == 0.0);
  CHECK(options.wall_least == 0.001);
  CHECK(options.wall_most == 0.005);
  CHECK(options.max_grasps == PlanOptions().max_grasps);
}

TEST_CASE("a wrong configuration of the planner is refused with its line or field",
          "[planner][hostile]") {
  const test::TempFolder folder;
  const auto refused = [&](const std::string& text) {
    CHECK_THROWS_AS(load_plan_options(folder.write("p.toml", text)), io::FileError);
  };
  refused("nonsense = 1\n");
  refused("approach = \"far\"\n");
  refused("approach = -1.0\n");
  refused("max_grasps = 1.5\n");
  refused("unknown = \"maybe\"\n");
}

TEST_CASE("options of the command line win over the planner's configuration", "[planner]") {
  const test::TempFolder folder;
  const std::string config =
      "--config " + folder.write("p.toml", "unknown = \"free\"\napproach = 0.08\n");
  CHECK(settings_of(config).plan.unknown == UnknownPolicy::kFree);
  const PlannerSettings settings = settings_of(config + " --unknown target-shadow");
  CHECK(settings.plan.unknown == UnknownPolicy::kTargetShadow);
  CHECK(settings.plan.approach == 0.08);
  CHECK(settings.gripper.name == "franka");
}

TEST_CASE("a gripper that is not known is wrong usage of the planner", "[planner]") {
  CHECK_THROWS_AS(settings_of("--gripper no_such_hand"), CLI::ParseError);
  CHECK_THROWS_AS(settings_of("--gripper none.toml"), io::FileError);
}

}  // namespace
}  // namespace quadrille

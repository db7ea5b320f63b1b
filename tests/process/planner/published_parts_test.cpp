// The maps and shapes that the planner publishes beside grasps.
#include <chrono>
#include <thread>

#include "process/planner/asked_planner.hpp"

namespace quadrille {
namespace {

using namespace test;

TEST_CASE("the newest map is published when clouds stop coming", "[planner][process]") {
  Asked asked("--occupancy-period 1");
  asked.show(1);
  asked.show(2);
  for (int tries = 0; tries < 1000 && asked.channels.count("OCCUPANCY") < 2; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (const auto job = asked.node().find_spare_job()) asked.node().work(*job);
  }
  CHECK(asked.channels.count("OCCUPANCY") == 2);
  CHECK(asked.map_utime == 2);
  CHECK_FALSE(asked.node().find_spare_job());
}

TEST_CASE("shapes come with each plan and occupancy at its own pace, or not at all",
          "[planner][process]") {
  using Channels = std::multiset<std::string>;
  // An hour: the second plan comes sooner.
  Asked often("--occupancy-period 3600");
  often.show(1);
  often.show(2);
  CHECK(often.channels ==
        Channels{"GRASPS", "GRASPS", "COLLISION_SHAPES", "COLLISION_SHAPES", "OCCUPANCY"});
  Asked each("--occupancy-period 0");
  each.show(1);
  each.show(2);
  CHECK(each.channels.count("OCCUPANCY") == 2);
  Asked neither("--no-shapes --no-occupancy");
  neither.show(1);
  CHECK(neither.channels == Channels{"GRASPS"});
}

}  // namespace
}  // namespace quadrille

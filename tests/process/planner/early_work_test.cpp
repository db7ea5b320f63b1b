// What the planner does on a cloud before its quadrics come.
#include <string>
#include <utility>

#include "process/chain.hpp"
#include "process/planner/asked_planner.hpp"
#include "process/planner/shown_table.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

using test::kBack;
using test::kCautious;
using test::kFront;
using test::kUsPerSecond;

}  // namespace

TEST_CASE("work that is done before quadrics come changes no plan", "[process][early]") {
  const std::string still, moves = "--pose-channel POSE";
  for (const auto& [detector, planner] : {std::pair(still, still), {moves, kCautious}}) {
    test::Chain late(detector, planner), early(detector, planner);
    early.work_early();
    for (test::Chain* each : {&late, &early}) {
      test::show_from(*each, 1 * kUsPerSecond, kFront);
      test::show_from(*each, 2 * kUsPerSecond, kBack);
      test::show_from(*each, 3 * kUsPerSecond, kFront);
    }
    CHECK_FALSE(early.grasps().grasps.empty());
    CHECK(early.bytes_of("GRASPS") == late.bytes_of("GRASPS"));
    CHECK(early.early_jobs() == 3);
  }
}

TEST_CASE("each cloud is prepared once, and none whose quadrics have come", "[process][early]") {
  test::Asked asked;
  PlannerNode& node = asked.node();
  CHECK_FALSE(node.find_early_job());
  const bus::CloudMessage cloud{5, 0, test::asked_cloud()};
  asked.give("POINT_CLOUD", bus::encode_cloud(cloud, bus::CloudFormat::kDrake));
  const auto job = node.find_early_job();
  REQUIRE(job);
  CHECK(job->cloud_utime == 5);
  CHECK_FALSE(node.find_early_job());
  asked.show(6);
  CHECK_FALSE(node.find_early_job());
}

TEST_CASE("a planner that plans on request prepares nothing", "[process][early]") {
  test::Asked asked("--on-request");
  const bus::CloudMessage cloud{5, 0, test::asked_cloud()};
  asked.give("POINT_CLOUD", bus::encode_cloud(cloud, bus::CloudFormat::kDrake));
  CHECK_FALSE(asked.node().find_early_job());
}

}  // namespace quadrille

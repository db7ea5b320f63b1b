// Further cameras of both processes: their clouds are counted, refused and placed in the same way.
#include <string>

#include "process/chain.hpp"
#include "process/planner/shown_table.hpp"
#include "process/scene_messages.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

using test::Chain;
using test::kBack;
using test::kFront;
using test::kUsPerSecond;
using test::show_from;
using test::take_from;

const std::string kSideCamera = "--pose-channel POSE --view-camera SIDE=SIDE_POSE";

/// Checks what a status says of two clouds that came whole, of which one had a pose, and a third
/// that was cut short.
template <class Status>
void check_counts(const Status& status) {
  CHECK(status.decoded_views == 2);
  REQUIRE(status.num_rejected_views == 1);
  CHECK(status.rejected_views[0].name == "cut_short");
  REQUIRE(status.num_unplaced_views == 1);
  CHECK(status.unplaced_views[0].name == "no_pose");
  CHECK(status.failed == 0);
  CHECK(status.remembered_views == 2);
  // The poses are exact, so what is left is noise.
  CHECK(status.pose_correction >= 0.0);
  CHECK(status.pose_correction < 0.003);
}

TEST_CASE("the status counts what came of the clouds of further cameras",
          "[process][memory][cameras]") {
  Chain chain(kSideCamera, kSideCamera);
  chain.take("SIDE", {std::byte{1}, std::byte{2}});
  take_from(chain, "SIDE", "NOBODY", 1 * kUsPerSecond, kBack);
  chain.wait();
  CHECK(chain.detector_status().remembered_views == 0);
  CHECK(chain.planner_status().remembered_views == 0);
  take_from(chain, "SIDE", "SIDE_POSE", 2 * kUsPerSecond, kBack);
  show_from(chain, 2 * kUsPerSecond, kFront);
  CHECK(chain.detector_status().decoded == 1);
  check_counts(chain.detector_status());
  check_counts(chain.planner_status());
  chain.take("FORGET", test::forget_all_bytes());
  CHECK(chain.detector_status().remembered_views == 0);
  CHECK(chain.planner_status().remembered_views == 0);
}

TEST_CASE("further cameras know the robot in the fixed frame alone",
          "[process][memory][cameras][robot]") {
  Chain chain(kSideCamera, kSideCamera);
  const std::string frame = GENERATE("world", "camera");
  chain.take("ROBOT", test::robot_bytes(0, frame, {test::ball_message({0.0, 0.0, 1.0}, 0.05)}));
  // A cloud without a pose is not remembered, and refuses nothing.
  take_from(chain, "SIDE", "NOBODY", 1 * kUsPerSecond, kBack);
  chain.wait();
  take_from(chain, "SIDE", "SIDE_POSE", 2 * kUsPerSecond, kBack);
  const bool known = frame == "world";
  const detector_status_t detector = chain.detector_status();
  const planner_status_t planner = chain.planner_status();
  CHECK(detector.failed + planner.failed == 0);
  CHECK(detector.remembered_views == (known ? 1 : 0));
  CHECK(planner.remembered_views == (known ? 1 : 0));
  CHECK(detector.num_rejected == 0);
  CHECK(detector.num_rejected_knowledge == (known ? 0 : 1));
  CHECK(planner.num_rejected_knowledge == (known ? 0 : 1));
}

}  // namespace
}  // namespace quadrille

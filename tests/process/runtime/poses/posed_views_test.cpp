#include "process/runtime/poses/posed_views.hpp"

#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <string>
#include <vector>

#include "process/encode_pose.hpp"
#include "process/logged_lines.hpp"
#include "process/runtime/poses/moving_camera.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

using test::encode_pose;
using test::kMs;

Eigen::Isometry3d shifted(double x) { return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0)); }

/// A camera at rest, and one that moves; what comes of their clouds is noted.
class TwoCameras {
 public:
  TwoCameras()
      : views({{"REST", "", shifted(2.0)}, {"MOVING", "POSE", {}}}, 1.0, 0.05,
              [this](int camera, const bus::CloudMessage& cloud, const CameraPose& pose) {
                const double x = pose.X_WK ? pose.X_WK->translation().x() : -1.0;
                done.push_back({camera, cloud.utime, x});
              }) {}

  void cloud(const std::string& channel, std::int64_t utime) {
    bus::CloudMessage message;
    message.utime = utime;
    message.cloud.points = {{0.0f, 0.0f, 1.0f}};
    if (const auto job = views.add(views.camera_of(channel), std::move(message))) job->run();
  }
  void pose(std::int64_t utime, double x) {
    CHECK(views.receive_pose("POSE", encode_pose(utime, shifted(x)), &refusals));
  }
  void pass(std::int64_t now) {
    std::vector<Job> jobs;
    views.take_due(Node::Time(now), &jobs);
    for (const Job& job : jobs) job.run();
  }

  struct Done {
    int camera;
    std::int64_t utime;
    double x;
    bool operator==(const Done&) const = default;
  };
  std::vector<Done> done;
  Refusals refusals;
  PosedViews views;
};

TEST_CASE("each further camera has its number, and its own poses", "[process][cameras]") {
  TwoCameras two;
  CHECK(two.views.camera_of("REST") == 1);
  CHECK(two.views.camera_of("MOVING") == 2);
  CHECK(two.views.camera_of("POSE") == 0);
  CHECK(two.views.channel(2) == "MOVING");
  two.cloud("REST", 5 * kMs);
  CHECK(two.done == std::vector<TwoCameras::Done>{{1, 5 * kMs, 2.0}});
  two.pose(0, 0.0);
  two.cloud("MOVING", 5 * kMs);
  CHECK(two.done.size() == 1);
  two.pose(10 * kMs, 0.01);
  two.pass(11 * kMs);
  REQUIRE(two.done.size() == 2);
  CHECK(two.done[1].camera == 2);
  CHECK(two.done[1].x == Approx(0.005));
  CHECK(two.views.decoded() == 2);
  CHECK(two.views.find_oddities().empty());
}

TEST_CASE("messages of other channels are no poses of further cameras", "[process][cameras]") {
  TwoCameras two;
  CHECK_FALSE(two.views.receive_pose("ELSEWHERE", encode_pose(0, shifted(0.0)), &two.refusals));
  const test::LoggedLines log;
  CHECK(two.views.receive_pose("POSE", {}, &two.refusals));
  CHECK(two.refusals.counts().total() == 1);
}

TEST_CASE("clouds that are refused or get no pose are counted by their reasons",
          "[process][cameras]") {
  TwoCameras two;
  const test::LoggedLines log;
  CHECK_FALSE(two.views.add(1, bus::Rejection{bus::RejectReason::kCutShort, "cut"}));
  two.cloud("MOVING", 5 * kMs);
  two.pass(200 * kMs);
  CHECK(two.views.decoded() == 1);
  detector_status_t status;
  two.views.fill(&status);
  CHECK(status.decoded_views == 1);
  REQUIRE(status.num_rejected_views == 1);
  CHECK(status.rejected_views[0].count == 1);
  REQUIRE(status.num_unplaced_views == 1);
  CHECK(status.unplaced_views[0].count == 1);
  CHECK(two.views.find_oddities().size() == 2);
}

}  // namespace
}  // namespace quadrille

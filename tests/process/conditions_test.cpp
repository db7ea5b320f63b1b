// Directions of approach in the fixed frame, for clouds whose camera's pose comes.
#include <cmath>
#include <string>

#include "process/chain.hpp"
#include "process/encode_pose.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

using test::Chain;
using test::encode_pose;

/// A can and a ball on a table, seen by a camera at this place of the table's frame, which is W.
struct FromThere {
  explicit FromThere(const Eigen::Vector3d& p_WK) : X_KW(test::world_seen_from(p_WK)) {
    std::vector<test::Patch> patches = test::can(X_KW * test::translation(0, 0, 0.05), 0.03, 0.1);
    patches.push_back(test::sphere(X_KW * test::translation(0.02, 0.15, 0.03), 0.03));
    patches.push_back(test::rectangle(X_KW, 2.0, 2.0));
    test::Camera camera;
    camera.noise = 0.0005;
    cloud = test::render(patches, camera);
    cloud.frame = "eye";
  }

  /// Gives the cloud, with the camera's pose at its time.
  void show(Chain& chain, std::int64_t utime) const {
    chain.take("POSE", encode_pose(utime, X_KW.inverse()));
    chain.take("POINT_CLOUD", bus::encode_cloud({utime, 0, cloud}, bus::CloudFormat::kDrake));
  }

  Eigen::Isometry3d X_KW;
  PointCloud cloud;
};

Eigen::Vector3d approach_of(const grasp_t& grasp) {
  const double* q = grasp.pose.quaternion;
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * Eigen::Vector3d::UnitZ();
}

bool is_refused(const grasps_t& grasps, const std::string& why) {
  for (const count_t& entry : grasps.rejected) {
    if (entry.name == why) return entry.count > 0;
  }
  return false;
}

const double kCosine = std::cos(20.0 * std::acos(-1.0) / 180.0);

}  // namespace

TEST_CASE("a hand that is to come from above does so wherever the camera moves",
          "[process][conditions]") {
  Chain chain("", "--pose-channel POSE --approach=0,0,-1,20");
  std::int64_t utime = 1000;
  for (const Eigen::Vector3d& p_WK :
       {Eigen::Vector3d(0.5, 0.1, 0.5), Eigen::Vector3d(-0.3, -0.4, 0.6),
        Eigen::Vector3d(0.1, 0.7, 0.4)}) {
    const FromThere there(p_WK);
    there.show(chain, utime += 1000);
    const grasps_t grasps = chain.grasps();
    CHECK(grasps.utime == utime);
    CHECK(grasps.frame == "eye");
    REQUIRE_FALSE(grasps.grasps.empty());
    CHECK(is_refused(grasps, "approach"));
    for (const grasp_t& grasp : grasps.grasps) {
      // In the camera's frame, as all results are here.
      const Eigen::Vector3d approach_W = there.X_KW.linear().transpose() * approach_of(grasp);
      CHECK(approach_W.dot(Eigen::Vector3d(0, 0, -1)) > kCosine - 1e-6);
    }
  }
}

TEST_CASE("without poses directions are in the camera's frame", "[process][conditions]") {
  const FromThere there({0.5, 0.1, 0.5});
  Chain chain("", "--approach=0,0,1,20");
  chain.take("POINT_CLOUD", bus::encode_cloud({1000, 0, there.cloud}, bus::CloudFormat::kDrake));
  REQUIRE_FALSE(chain.grasps().grasps.empty());
  for (const grasp_t& grasp : chain.grasps().grasps) {
    CHECK(approach_of(grasp).z() > kCosine - 1e-6);
  }
}

TEST_CASE("without the pose that its conditions need no cloud is planned on",
          "[process][conditions]") {
  const FromThere there({0.5, 0.1, 0.5});
  const auto bytes = bus::encode_cloud({1000, 0, there.cloud}, bus::CloudFormat::kDrake);
  for (const std::string option : {"--approach=0,0,-1,20", "--reach=0,0,0,0,2"}) {
    CAPTURE(option);
    Chain chain("", "--pose-channel POSE " + option);
    chain.take("POINT_CLOUD", bytes);
    chain.wait();
    CHECK(chain.grasps().grasps.empty());
    CHECK(chain.grasps().frame == "eye");
    REQUIRE_FALSE(chain.grasps().warnings.empty());
    CHECK(chain.grasps().warnings.back().find("the camera's pose is not known: no pose") == 0);
  }
  // Without conditions the poses are not needed.
  Chain free("", "--pose-channel POSE");
  free.take("POINT_CLOUD", bytes);
  free.wait();
  CHECK_FALSE(free.grasps().grasps.empty());
}

TEST_CASE("directions, reaches and numbers that are none are wrong usage of the planner",
          "[process][conditions]") {
  for (const std::string wrong : {"--approach=0,0,0,20", "--approach=0,0,1", "--approach=0,0,1,0",
                                  "--reach=0,0,0,1", "--reach=0,0,0,2,1", "--reach=1e9,0,0,0,1",
                                  "--reach=0,0,0,0,0", "--reach=0,0,0,0,1000", "--per-target=-1"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(Chain("", wrong), CLI::ParseError);
  }
}

}  // namespace quadrille

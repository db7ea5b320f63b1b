// Clouds in the camera's frame and in the fixed one, through both processes.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "process/chain.hpp"
#include "process/encode_pose.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detection.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

using Bytes = std::vector<std::byte>;
using test::Chain;
using test::encode_pose;

Eigen::Isometry3d X_WK() {
  return Eigen::Translation3d(1.0, -0.5, 0.75) * Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
}

/// A ball and a can on a table.
PointCloud scene() {
  const Eigen::Isometry3d X_KT = test::world_seen_from({0.5, 0.1, 0.5});
  std::vector<test::Patch> patches = test::can(X_KT * test::translation(0, 0, 0.05), 0.03, 0.1);
  patches.push_back(test::sphere(X_KT * test::translation(0.02, 0.15, 0.03), 0.03));
  patches.push_back(test::rectangle(X_KT, 2.0, 2.0));
  test::Camera camera;
  camera.noise = 0.0005;
  return test::render(patches, camera);
}

Bytes encode_cloud(std::int64_t utime, PointCloud cloud, const std::string& frame) {
  cloud.frame = frame;
  return bus::encode_cloud({utime, 0, cloud}, bus::CloudFormat::kDrake);
}

/// The camera-frame messages of the scene.
struct InCamera {
  InCamera() : chain("", "") { chain.take("POINT_CLOUD", encode_cloud(1000, scene(), "eye")); }
  Chain chain;
};

/// The best score on each target.
std::map<int, double> best_scores(const grasps_t& grasps) {
  std::map<int, double> best;
  for (const grasp_t& grasp : grasps.grasps) {
    best[grasp.target] = std::max(best[grasp.target], grasp.score);
  }
  return best;
}

/// Sees to it that a chain has the grasps of the camera's frame, in the frame of its quadrics: on
/// the same targets, about as good, and touching them. The rounding of a round thing's pose decides
/// which of its many grasps are tried.
void check_grasps(const Chain& chain, const Chain& in_K) {
  const std::map<int, double> got = best_scores(chain.grasps());
  const std::map<int, double> wanted = best_scores(in_K.grasps());
  REQUIRE_FALSE(wanted.empty());
  REQUIRE(got.size() == wanted.size());
  for (const auto& [target, score] : wanted) CHECK(got.at(target) == Approx(score).epsilon(0.15));
  std::map<int, Quadric> quadric_of;
  for (const Detection& d : chain.quadrics().detections) quadric_of.emplace(d.id, d.Q_C);
  for (const grasp_t& grasp : chain.grasps().grasps) {
    for (const double(&p)[3] : grasp.contacts) {
      CHECK(std::abs(quadric_of.at(grasp.target).distance({p[0], p[1], p[2]})) < 0.002);
    }
  }
}

}  // namespace

TEST_CASE("results on clouds in the camera's frame can be had in the fixed frame",
          "[process][frames]") {
  const InCamera camera;
  const std::string options = "--pose-channel POSE --result-frame world";
  Chain chain(options, options);
  chain.take("POSE", encode_pose(1000, X_WK()));
  chain.take("POINT_CLOUD", encode_cloud(1000, scene(), "eye"));
  check_grasps(chain, camera.chain);
  CHECK(chain.grasps().frame == "world");
  const bus::QuadricsMessage in_W = chain.quadrics(), in_K = camera.chain.quadrics();
  CHECK(in_W.frame == "world");
  REQUIRE(in_W.detections.size() == in_K.detections.size());
  for (std::size_t n = 0; n < in_K.detections.size(); ++n) {
    const Detection wanted = moved(in_K.detections[n], X_WK());
    const Detection& got = in_W.detections[n];
    CHECK((got.Q_C.coefficients() - wanted.Q_C.coefficients()).norm() < 1e-9);
  }
}

TEST_CASE("clouds in the fixed frame are seen from where their camera's pose says",
          "[process][frames]") {
  // Exact in single precision: a quarter turn, and points on a lattice.
  PointCloud cloud_K = scene();
  for (Eigen::Vector3f& p : cloud_K.points) p = (p * 65536.0f).array().round() / 65536.0f;
  Chain in_K("", "");
  in_K.take("POINT_CLOUD", encode_cloud(1000, cloud_K, "eye"));
  const Bytes cloud_W = encode_cloud(1000, moved(cloud_K, X_WK()), "map");
  const std::string moving = "--pose-channel POSE --cloud-frame world";
  const std::string fixed = "--camera-pose=1,-0.5,0.75,0.5,0.5,-0.5,0.5 --cloud-frame world";
  for (const std::string& options : {moving, fixed}) {
    Chain chain(options, options);
    if (options == moving) chain.take("POSE", encode_pose(1000, X_WK()));
    chain.take("POINT_CLOUD", cloud_W);
    CAPTURE(options);
    CHECK(chain.grasps().frame == "map");
    CHECK(chain.quadrics().frame == "map");
    check_grasps(chain, in_K);
    CHECK(chain.quadrics().detections.at(0).track > 0);
  }
  Chain back(moving + " --result-frame camera", moving + " --result-frame camera");
  back.take("POSE", encode_pose(1000, X_WK()));
  back.take("POINT_CLOUD", cloud_W);
  CHECK(back.grasps().frame == "camera");
  check_grasps(back, in_K);
}

TEST_CASE("without the pose that it needs no cloud is planned on, and the messages say why",
          "[process][frames]") {
  const std::string options = "--pose-channel POSE --cloud-frame world";
  Chain chain(options, options);
  chain.take("POINT_CLOUD", encode_cloud(1000, moved(scene(), X_WK()), "map"));
  chain.wait();
  CHECK(chain.quadrics().detections.empty());
  CHECK(chain.grasps().grasps.empty());
  CHECK(chain.grasps().frame == "map");
  REQUIRE(chain.grasps().warnings.size() == 2);
  CHECK(chain.grasps().warnings[1].find("the camera's pose is not known: no pose has come") == 0);
  // An empty answer is in the frame that was asked for as well.
  Chain in_world("--pose-channel POSE --result-frame world",
                 "--pose-channel POSE --result-frame world");
  in_world.take("POINT_CLOUD", encode_cloud(1000, scene(), "eye"));
  in_world.wait();
  CHECK(in_world.quadrics().frame == "world");
  CHECK(in_world.grasps().frame == "world");
  // Quadrics from elsewhere change nothing.
  Chain careless(options, options);
  careless.take("POSE", encode_pose(5000, X_WK()));
  careless.take("POINT_CLOUD", encode_cloud(1000, moved(scene(), X_WK()), "map"));
  careless.wait();
  CHECK(careless.grasps().grasps.empty());
}

TEST_CASE("a cloud between two poses gets the pose between them, whichever comes first",
          "[process][frames]") {
  const InCamera camera;
  const std::string options = "--pose-channel POSE --result-frame world";
  Eigen::Isometry3d before = X_WK(), after = X_WK();
  before.translation().x() -= 0.01;
  after.translation().x() += 0.03;
  const Bytes cloud = encode_cloud(1000, scene(), "eye");
  const Bytes first = encode_pose(990, before), second = encode_pose(1030, after);
  const bool waits = GENERATE(false, true);
  Chain chain(options, options);
  chain.take("POSE", waits ? first : second);
  if (waits) chain.take("POINT_CLOUD", cloud);
  chain.take("POSE", waits ? second : first);
  if (!waits) chain.take("POINT_CLOUD", cloud);
  const bus::QuadricsMessage in_W = chain.quadrics(), in_K = camera.chain.quadrics();
  REQUIRE(in_W.detections.size() == in_K.detections.size());
  for (std::size_t n = 0; n < in_K.detections.size(); ++n) {
    const Detection wanted = moved(in_K.detections[n], X_WK());
    CHECK((in_W.detections[n].X_CQ.matrix() - wanted.X_CQ.matrix()).norm() < 1e-9);
  }
  check_grasps(chain, camera.chain);
}

TEST_CASE("quadrics that come before the planner has the pose wait with their cloud",
          "[process][frames][pairing]") {
  const std::string options = "--pose-channel POSE --result-frame world";
  Chain chain(options, options), slow(options, options);
  const Bytes cloud = encode_cloud(1000, scene(), "eye");
  for (Chain* each : {&chain, &slow}) {
    each->take("POSE", encode_pose(990, X_WK()));
    each->take("POINT_CLOUD", cloud);
    // Another one waits behind it.
    each->take("POINT_CLOUD", encode_cloud(2000, scene(), "eye"));
  }
  chain.take("POSE", encode_pose(1010, X_WK()));
  slow.take_slowly("POSE", encode_pose(1010, X_WK()));
  CHECK(slow.grasps().utime == 1000);
  CHECK(slow.bytes_of("GRASPS") == chain.bytes_of("GRASPS"));
  check_grasps(slow, chain);
}

TEST_CASE("a filter of the detector's process leaves the planner all that is in the way",
          "[process][report]") {
  const InCamera all;
  for (const std::string option : {"--only", "--report"}) {
    Chain chain(option + " sphere", "");
    chain.take("POINT_CLOUD", encode_cloud(1000, scene(), "eye"));
    CAPTURE(option);
    const std::vector<Detection> some = chain.quadrics().detections;
    CHECK(some.size() == all.chain.quadrics().detections.size());
    for (const Detection& d : some) CHECK(is_reported(d) == (d.type == QuadricType::kSphere));
    Chain targeted("", "--report sphere");
    targeted.take("POINT_CLOUD", encode_cloud(1000, scene(), "eye"));
    const grasps_t a = chain.grasps(), b = targeted.grasps();
    REQUIRE_FALSE(a.grasps.empty());
    REQUIRE(a.grasps.size() == b.grasps.size());
    // Each is one of those that are planned without any filter.
    for (const grasp_t& grasp : a.grasps) {
      int same = 0;
      for (const grasp_t& other : all.chain.grasps().grasps) {
        same += std::equal(grasp.pose.position, grasp.pose.position + 3, other.pose.position) &&
                grasp.score == other.score;
      }
      CHECK(same >= 1);
    }
  }
}

TEST_CASE("two filters at once are refused", "[process][report]") {
  CHECK_THROWS_AS(Chain("--only sphere --report cone", ""), CLI::ParseError);
}

TEST_CASE("the fixed frame cannot be asked for without a pose", "[process][frames]") {
  for (const std::string wrong :
       {"--cloud-frame world", "--result-frame world", "--cloud-frame table",
        "--pose-channel POSE --camera-pose 0,0,0,1,0,0,0"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(Chain(wrong, ""), CLI::ParseError);
    CHECK_THROWS_AS(Chain("", wrong), CLI::ParseError);
  }
  CHECK_THROWS_AS(Chain("", "--pose-channel QUADRICS"), CLI::ParseError);
}

}  // namespace quadrille

// What messages of a few kB can make the planner's process take.
#include <cmath>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <random>
#include <vector>

#include "process/planner/node.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/memory_limit.hpp"
#include "support/rounds.hpp"

namespace quadrille {
namespace {

using Bytes = std::vector<std::byte>;

/// A planner that is given quadrics with a cloud of a table with a ball.
class FedPlanner {
 public:
  FedPlanner() : node_(settings(), keep()) {
    const Eigen::Isometry3d X_KT = test::world_seen_from({0.5, 0.1, 0.5});
    cloud_.cloud = test::render(
        {test::sphere(X_KT * test::translation(0, 0, 0.03), 0.03), test::rectangle(X_KT, 2.0, 2.0)},
        {160, 120, 1.0 / 150.0});
    cloud_.digest = bus::digest_of(cloud_.cloud);
    encoded_ = bus::encode_cloud(cloud_, bus::CloudFormat::kDrake);
  }

  void take(const std::vector<Detection>& detections) {
    DetectionResult result;
    result.detections = detections;
    node_.receive("POINT_CLOUD", encoded_);
    const auto job = node_.receive("QUADRICS", bus::encode(bus::to_message(cloud_, result)));
    REQUIRE(job);
    node_.work(*job);
  }

  const PlannerNode& node() const { return node_; }
  /// The last answer.
  grasps_t grasps;

 private:
  /// With results in a frame that is askew, for which the map is turned.
  static PlannerSettings settings() {
    PlannerSettings settings;
    settings.gripper = franka_hand();
    settings.X_WK =
        Eigen::Isometry3d(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
    settings.frames.results = CloudFrame::kWorld;
    return settings;
  }
  bus::Publish keep() {
    return [this](const std::string& channel, std::span<const std::byte> bytes) {
      if (channel == "GRASPS") grasps.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
    };
  }

  bus::CloudMessage cloud_;
  Bytes encoded_;
  PlannerNode node_;
};

Detection ball_at(const Eigen::Vector3d& p_C, double radius, int id) {
  Detection d;
  d.id = id;
  d.type = QuadricType::kSphere;
  Vector10d q = Vector10d::Zero();
  q[0] = 1.0;
  d.Q_C = Quadric(q);
  d.X_CQ.translation() = p_C;
  d.dimensions = {{"radius", radius, 0.001}};
  d.extent_Q = {Eigen::Vector3d::Constant(-radius), Eigen::Vector3d::Constant(radius)};
  d.score = 1.0;
  return d;
}

/// Between 0.1 mm and 10,000 km, of either sign.
double any_length(std::mt19937& random) {
  const double length = std::pow(10.0, -4.0 + 11.0 * (random() / 4294967296.0));
  return random() % 2 ? length : -length;
}

/// Now and then as near as things on a table.
double any_place(std::mt19937& random) {
  return random() % 2 ? any_length(random) : 0.5 + 0.5 * (random() / 4294967296.0);
}

Detection any_detection(std::mt19937& random, int id) {
  Detection d = ball_at({any_place(random), any_place(random), any_place(random)}, 0.03, id);
  d.type = static_cast<QuadricType>(random() % kQuadricTypeCount);
  d.dimensions.clear();
  const double size = std::abs(any_length(random));
  for (int n = 0; n < 3; ++n) {
    d.dimensions.push_back({"size", random() % 2 ? size : std::abs(any_length(random)), 0.001});
  }
  Eigen::Vector3d half = Eigen::Vector3d::Constant(size);
  for (double& h : half) h = random() % 2 ? h : std::abs(any_length(random));
  d.extent_Q = {-half, half};
  d.X_CQ.linear() = Eigen::Quaterniond(1.0, any_length(random), any_length(random), 1.0)
                        .normalized()
                        .toRotationMatrix();
  return d;
}

constexpr std::size_t kMostMemory = std::size_t{512} << 20;

}  // namespace

TEST_CASE("two bodies ten kilometres away do not cost the planner gigabytes",
          "[process][hostile]") {
  FedPlanner planner;
  const test::MemoryLimit limit(kMostMemory);
  planner.take({ball_at({1e4, 0, 0.7}, 0.03, 1), ball_at({0, 0, 1e4}, 0.03, 2)});
  CHECK(planner.node().failed() == 0);
  REQUIRE(planner.grasps.num_rejected == 1);
  CHECK(planner.grasps.rejected[0].name == "far");
  CHECK(planner.grasps.rejected[0].count == 2);
}

TEST_CASE("bodies of any size and place keep the planner within its memory", "[process][hostile]") {
  std::mt19937 random(7);
  FedPlanner planner;
  const test::MemoryLimit limit(kMostMemory);
  for (int n = 0; n < 40 * test::rounds(); ++n) {
    CAPTURE(n);
    std::vector<Detection> detections;
    for (unsigned id = 1; id <= 1 + random() % 8; ++id) {
      detections.push_back(any_detection(random, static_cast<int>(id)));
    }
    planner.take(detections);
    CHECK(planner.node().failed() == 0);
  }
}

}  // namespace quadrille

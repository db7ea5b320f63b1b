// Grasps at the walls of an open box, of which one side was seen.
#include <algorithm>
#include <array>

#include "hand/hand.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/plan.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille {
namespace {

constexpr double kTrayLength = 0.2, kTrayWidth = 0.14, kTrayHeight = 0.06, kTrayWall = 0.003;

/// A part of the tray: a box around the origin of its frame.
struct Slab {
  Eigen::Isometry3d X_CB;
  Eigen::Vector3d size;

  bool contains(const Eigen::Vector3d& p_C, double margin) const {
    const Eigen::Vector3d p_B = X_CB.inverse() * p_C;
    return (p_B.cwiseAbs().array() <= 0.5 * size.array() + margin).all();
  }
};

/// A tray on a table that a camera sees from above at 45°.
struct Tray {
  Eigen::Isometry3d X_CW = test::world_seen_from({0.0, -0.45, 0.45});
  std::array<Slab, 5> slabs = {slab({0, 0, 0.5 * kTrayWall}, {kTrayLength, kTrayWidth, kTrayWall}),
                               slab({0.5 * (kTrayLength - kTrayWall), 0, 0.5 * kTrayHeight},
                                    {kTrayWall, kTrayWidth, kTrayHeight}),
                               slab({-0.5 * (kTrayLength - kTrayWall), 0, 0.5 * kTrayHeight},
                                    {kTrayWall, kTrayWidth, kTrayHeight}),
                               slab({0, 0.5 * (kTrayWidth - kTrayWall), 0.5 * kTrayHeight},
                                    {kTrayLength, kTrayWall, kTrayHeight}),
                               slab({0, -0.5 * (kTrayWidth - kTrayWall), 0.5 * kTrayHeight},
                                    {kTrayLength, kTrayWall, kTrayHeight})};

  Slab slab(const Eigen::Vector3d& middle_W, const Eigen::Vector3d& size) const {
    return {X_CW * Eigen::Isometry3d(Eigen::Translation3d(middle_W)), size};
  }

  GraspPlan plan() const {
    std::vector<test::Patch> patches = {test::rectangle(X_CW, 1.2, 1.0)};
    for (const Slab& part : slabs) {
      const std::vector<test::Patch> faces = test::box(part.X_CB, part.size);
      patches.insert(patches.end(), faces.begin(), faces.end());
    }
    const PointCloud cloud = test::render(patches, {640, 480, 1.0 / 600.0, 0.001});
    const DetectionResult found = detect(cloud);
    return plan_grasps(cloud, found.detections, franka_hand(), {}, {}, {}, found.boxes,
                       found.bodies);
  }
};

}  // namespace

TEST_CASE("the walls of a tray are held at their upper edge, though one side of each was seen",
          "[plan][points]") {
  const Tray tray;
  const GraspPlan plan = tray.plan();
  std::array<int, 5> held = {};
  int thin_grasps = 0;
  for (const Grasp& grasp : plan.grasps) {
    const Eigen::Vector3d middle_C = 0.5 * (grasp.contacts_C[0] + grasp.contacts_C[1]);
    const auto wall = std::find_if(tray.slabs.begin(), tray.slabs.end(),
                                   [&](const Slab& s) { return s.contains(middle_C, 0.003); });
    REQUIRE(wall != tray.slabs.end());
    ++held[static_cast<std::size_t>(wall - tray.slabs.begin())];
    if (grasp.width < 0.008) {
      ++thin_grasps;
      CHECK(grasp.unknown_contact);
      const Eigen::Vector3d closing_B =
          wall->X_CB.linear().transpose() * grasp.X_CG.linear().col(1);
      Eigen::Index thin = 0;
      wall->size.minCoeff(&thin);
      CHECK(std::abs(closing_B[thin]) > 0.95);
    }
    // The opened fingers are on either side of the wall, and not in it.
    const SweptHand hand =
        sweep_hand(franka_hand(), grasp.X_CG, grasp.preshape, grasp.width, grasp.approach);
    for (double x = -0.5; x <= 0.5; x += 0.02) {
      for (double z = -0.5; z <= 0.5; z += 0.02) {
        for (const Slab& slab : tray.slabs) {
          Eigen::Index thin = 0;
          slab.size.minCoeff(&thin);
          Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
          p_B[(thin + 1) % 3] = x * slab.size[(thin + 1) % 3];
          p_B[(thin + 2) % 3] = z * slab.size[(thin + 2) % 3];
          const Eigen::Vector3d p_C = slab.X_CB * p_B;
          CHECK_FALSE(hand.fingers[0].contains(p_C));
          CHECK_FALSE(hand.fingers[1].contains(p_C));
          CHECK_FALSE(hand.palm.contains(p_C));
        }
      }
    }
  }
  INFO(held[0] << ' ' << held[1] << ' ' << held[2] << ' ' << held[3] << ' ' << held[4]);
  // All four walls, not the floor.
  CHECK(held[0] == 0);
  CHECK(thin_grasps >= 4);
  for (std::size_t n = 1; n < held.size(); ++n) CHECK(held[n] > 0);
}

}  // namespace quadrille

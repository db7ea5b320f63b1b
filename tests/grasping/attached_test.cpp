// Shapes that are fixed to the hand touch nothing on the way to a grasp.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "grasping/known_scene.hpp"
#include "hand/oriented_box.hpp"
#include "quadrille/detector/solid_shape.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/shape.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("what is fixed to the hand touches neither the table nor a neighbour",
          "[surroundings][attached]") {
  CanScene scene;
  scene.with_neighbour = true;
  // A long thing beside the hand, across the direction in which it closes.
  const Eigen::AlignedBox3d held(Eigen::Vector3d(0.05, -0.015, -0.1),
                                 Eigen::Vector3d(0.14, 0.015, -0.035));
  const auto touches = [&](const Grasp& grasp) {
    bool any = false;
    for (double back = 0.0; back <= grasp.approach; back += 0.005) {
      Eigen::Isometry3d X_CG = grasp.X_CG;
      X_CG.translation() -= back * grasp.X_CG.linear().col(2);
      const OrientedBox box = box_between(X_CG, held.min(), held.max());
      any |= any_place_in({box}, [&](const Eigen::Vector3d& p_C) {
        const Eigen::Vector3d p_N = scene.X_CNeighbour.inverse() * p_C;
        const bool in_neighbour = std::hypot(p_N.x(), p_N.y()) < kCanRadius - 0.001 &&
                                  std::abs(p_N.z()) < 0.5 * kCanHeight - 0.001;
        return in_neighbour || height_in(scene, p_C) < -0.001;
      });
    }
    return any;
  };
  // There are thousands, of which some are as good as all.
  const auto some_hands = [&](const GraspQuery& asked) {
    const std::vector<Grasp> all = all_hands(scene, {}, UnknownPolicy::kFree, asked);
    std::vector<Grasp> some;
    for (std::size_t n = 0; n < all.size(); n += 13) some.push_back(all[n]);
    return some;
  };
  const std::vector<Grasp> bare = some_hands({});
  const auto touching = std::count_if(bare.begin(), bare.end(), touches);
  CAPTURE(bare.size(), touching);
  REQUIRE(touching > 10);
  REQUIRE(static_cast<std::size_t>(touching) < bare.size());
  GraspQuery query;
  SolidShape shape;
  shape.kind = "box";
  shape.X_CS.translation() = held.center();
  shape.dimensions = {held.sizes().x(), held.sizes().y(), held.sizes().z()};
  query.attached = {with_geometry(shape)};
  const std::vector<Grasp> laden = some_hands(query);
  CHECK_FALSE(laden.empty());
  CHECK(std::none_of(laden.begin(), laden.end(), touches));
  // It may not touch shapes that are given, either.
  SolidShape wall = shape;
  wall.X_CS = scene.X_CW * translation(0.0, 0.0, 0.4);
  wall.dimensions = {1.0, 1.0, 0.3};
  query.obstacles = {with_geometry(wall)};
  const auto in_wall = [&](const Grasp& grasp) {
    const OrientedBox box = box_between(grasp.X_CG, held.min(), held.max());
    return any_place_in({box}, [&](const Eigen::Vector3d& p_C) {
      return in_block(wall.X_CS.inverse(), Eigen::Vector3d(0.5, 0.5, 0.15), -0.001, p_C);
    });
  };
  const std::vector<Grasp> walled = some_hands(query);
  CHECK(std::none_of(walled.begin(), walled.end(), in_wall));
}

#include "view/live/scene_frames.hpp"

#include "support/catch.hpp"

using namespace quadrille;

namespace {

const Eigen::Isometry3d kX_WK(Eigen::Translation3d(1.0, 2.0, 3.0) *
                              Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()));

bool is_pose(const std::optional<Eigen::Isometry3d>& X, const Eigen::Isometry3d& expected) {
  return X && X->isApprox(expected, 1e-12);
}

}  // namespace

TEST_CASE("frames that messages name are placed in the frame of the scene", "[view][frames]") {
  const Eigen::Isometry3d same = Eigen::Isometry3d::Identity();
  const view::SceneFrames world{"world", "depth", false, kX_WK};
  CHECK(is_pose(world.X_SF(""), same));
  CHECK(is_pose(world.X_SF("world"), same));
  CHECK(is_pose(world.X_SF("camera"), kX_WK));
  CHECK(is_pose(world.X_SF("depth"), kX_WK));
  CHECK(is_pose(world.X_SK(), kX_WK));
  CHECK_FALSE(world.X_SF("flange"));

  const view::SceneFrames camera{"depth", "depth", false, kX_WK};
  CHECK(is_pose(camera.X_SF("camera"), same));
  CHECK(is_pose(camera.X_SF("world"), kX_WK.inverse()));

  const view::SceneFrames base{"base", "base", true, kX_WK};
  CHECK(is_pose(base.X_SF("world"), same));
  CHECK(is_pose(base.X_SF("camera"), kX_WK));
  const view::SceneFrames turned{"camera", "base", true, kX_WK};
  CHECK(is_pose(turned.X_SF("base"), kX_WK.inverse()));
}

TEST_CASE("without a pose only frames that need none are placed", "[view][frames]") {
  const view::SceneFrames world{"world", "depth", false, {}};
  CHECK(world.X_SF("world"));
  CHECK(world.X_SF(""));
  CHECK_FALSE(world.X_SF("camera"));
  CHECK_FALSE(world.X_SF("depth"));
  CHECK_FALSE(world.X_SK());
  const view::SceneFrames camera{"depth", "depth", false, {}};
  CHECK(camera.X_SF("camera"));
  CHECK_FALSE(camera.X_SF("world"));
}

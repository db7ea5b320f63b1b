// Space beside the image that lies over seen space.
#include <octomap/OcTree.h>

#include <sstream>

#include "grasping/mapped_scene.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// The scene in a grid that reaches beside its image, before and after space above seen space is
/// cleared.
struct WideGrid {
  Scene scene;
  Eigen::Vector3d up = table_detection().X_CQ.linear().col(2);
  OccupancyGrid before, grid;

  WideGrid(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
      : before(map_of(scene.cloud, scene.view, {low, high})), grid(cleared(low, high)) {}

  OccupancyGrid cleared(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const {
    SpaceMapper mapper({low, high}, kResolution);
    mapper.add(scene.cloud, scene.view);
    return std::move(mapper).take_cleared(scene.view, up);
  }
};

}  // namespace

TEST_CASE("what hangs over seen space beside the image is free, what a surface hides is not",
          "[occupancy]") {
  const WideGrid wide({-0.15, -0.6, 0.3}, {0.15, 0.15, 0.95});
  const auto& [scene, up, before, grid] = wide;
  int cleared = 0, hidden = 0;
  for (int k = 0; k < grid.size().z(); ++k) {
    for (int j = 0; j < grid.size().y(); ++j) {
      for (int i = 0; i < grid.size().x(); ++i) {
        const Voxel was = before.at(i, j, k), is = grid.at(i, j, k);
        const Eigen::Vector3d p_C = grid.centre(i, j, k), p_V = scene.view.to_view(p_C);
        const Eigen::Vector2i uv = scene.view.pixel(p_V);
        const double depth = scene.view.depth(uv.x(), uv.y());
        const bool behind = depth > 0.0 && depth < p_V.z();
        if (was != Voxel::kUnknown) REQUIRE(is == was);
        if (behind) REQUIRE(is == was);
        hidden += behind && was == Voxel::kUnknown;
        if (is == was) continue;
        ++cleared;
        REQUIRE(is == Voxel::kClear);
        // Straight below it some voxel was seen free.
        double down = 0.0;
        const auto seen_free = [&grid = grid, &scene = scene](const Eigen::Vector3d& p) {
          return grid.at(p) == Voxel::kFree && scene.view.sees_past(p, 0.0001);
        };
        while (!seen_free(p_C - down * up) && down < 1.0) down += 0.001;
        REQUIRE(down < 1.0);
      }
    }
  }
  CHECK(cleared > 1000);
  CHECK(hidden > 1000);
}

TEST_CASE("each voxel is cleared exactly if its own pixels and the voxel below allow it",
          "[occupancy]") {
  const WideGrid wide({-0.3, -0.5, 0.4}, {0.3, 0.15, 0.95});
  const auto& [scene, up, before, grid] = wide;
  std::vector<Voxel> states = before.states();
  int axis = 0;
  const double steepest = up.cwiseAbs().maxCoeff(&axis);
  const Eigen::Vector3i size = grid.size();
  const auto shift = [&up = up, steepest](int n) -> Eigen::Vector3i {
    return (n * up / steepest).array().round().cast<int>().matrix();
  };
  int looked_at = 0;
  for (int n = 1; n < size[axis]; ++n) {
    const Eigen::Vector3i step = shift(n) - shift(n - 1);
    const int layer = up[axis] > 0.0 ? n : size[axis] - 1 - n;
    for (int a = 0; a < size[(axis + 1) % 3]; ++a) {
      for (int b = 0; b < size[(axis + 2) % 3]; ++b) {
        Eigen::Vector3i at;
        at[axis] = layer, at[(axis + 1) % 3] = a, at[(axis + 2) % 3] = b;
        const Eigen::Vector3i under = at - step;
        if ((under.array() < 0).any() || (under.array() >= size.array()).any()) continue;
        Voxel& state = states[grid.index(at.x(), at.y(), at.z())];
        const Voxel below = states[grid.index(under.x(), under.y(), under.z())];
        if (state != Voxel::kUnknown) continue;
        if (below != Voxel::kFree && below != Voxel::kClear) continue;
        ++looked_at;
        if (!scene.view.meets_surface(grid.centre(at.x(), at.y(), at.z()), 0.5 * kResolution)) {
          state = Voxel::kClear;
        }
      }
    }
  }
  CHECK(looked_at > 10000);
  CHECK((grid.states() == states));
}

TEST_CASE("what stands over unknown or occupied space stays unknown", "[occupancy]") {
  // All of it beside the image: nothing below it was seen.
  const WideGrid wide({-0.1, -1.2, 0.3}, {0.1, -0.9, 0.5});
  for (const Voxel state : wide.grid.states()) REQUIRE(state == Voxel::kUnknown);
}

TEST_CASE("octrees show what was seen, not what is taken for clear", "[occupancy]") {
  const WideGrid wide({-0.15, -0.6, 0.3}, {0.15, 0.15, 0.95});
  REQUIRE(wide.grid.states() != wide.before.states());
  const auto bytes_of = [](const OccupancyGrid& of) {
    std::ostringstream stream;
    of.to_octree()->write(stream);
    return stream.str();
  };
  CHECK(bytes_of(wide.grid).size() > 1000);
  CHECK((bytes_of(wide.grid) == bytes_of(wide.before)));
}

#include "views/lids_of_views.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "views/search_view.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kCanRadius = 0.04, kCanHeight = 0.1, kTangent = 1.0 / 450.0;
const Eigen::Isometry3d kTablePose = world_seen_from({0.0, -0.45, 0.4});

/// Searches a cloud for planes and surfaces with the standard options.
std::optional<Scene> scene_of(const PointCloud& cloud) {
  StageClock clock;
  return search_view(cloud, {}, {}, clock);
}

PointCloud can_on_table() {
  std::vector<Patch> patches =
      can(kTablePose * translation(0, 0, 0.5 * kCanHeight), kCanRadius, kCanHeight);
  patches.push_back(rectangle(kTablePose, 1.0, 0.9));
  Camera camera;
  camera.width = 480, camera.height = 360, camera.pitch = kTangent;
  return render(patches, camera);
}

/// The can's wall among the surfaces of a scene.
const Surface& can_wall(const Scene& scene) {
  const auto found =
      std::find_if(scene.surfaces.begin(), scene.surfaces.end(),
                   [](const Surface& s) { return s.fit.family == Family::kCylinder; });
  REQUIRE(found != scene.surfaces.end());
  return *found;
}

}  // namespace

TEST_CASE("the outline of a can's lid is its upper edge", "[views][lid]") {
  const PointCloud cloud = can_on_table();
  const std::optional<Scene> scene = scene_of(cloud);
  REQUIRE(scene);
  REQUIRE(scene->views.size() == 1);
  const std::vector<OutlinePoint> outline = outline_of_lids(can_wall(*scene), *scene);
  CHECK(outline.size() > 10);
  for (const OutlinePoint& o : outline) {
    const Eigen::Vector3d p_W = kTablePose.inverse() * o.p_C;
    // Pixels are stretched along the lid.
    CHECK(p_W.head<2>().norm() == Approx(kCanRadius).margin(1.6 * kTangent * o.p_C.z()));
    CHECK(p_W.z() == Approx(kCanHeight).margin(0.0005));
  }
}

TEST_CASE("neither other surfaces nor views without points have outlines of lids",
          "[views][lid][degenerate]") {
  const PointCloud cloud = can_on_table();
  std::optional<Scene> scene = scene_of(cloud);
  REQUIRE(scene);
  Surface wall = can_wall(*scene);
  wall.fit.family = Family::kGeneral;
  CHECK(outline_of_lids(wall, *scene).empty());
  wall.fit.family = Family::kCylinder;
  scene->views.front().pyramid.reset();
  scene->views.front().cloud = {};
  CHECK(outline_of_lids(wall, *scene).empty());
}

#include "lab/scoring/frame.hpp"

#include <cmath>
#include <map>

#include "support/catch.hpp"

namespace quadrille::scoring {
namespace {

TEST_CASE("the points of a generated frame lie on the surfaces that they are labelled with",
          "[scoring][frame]") {
  const Frame frame = frame_of(scene::make_scene({scene::Family::kMedium, 1000}));
  CHECK(frame.name == "medium 1000");
  REQUIRE(frame.labels.size() == frame.cloud.points.size());
  REQUIRE(frame.normals.size() == frame.cloud.points.size());
  std::map<int, const TrueSurface*> surfaces;
  for (const TrueSurface& surface : frame.surfaces) surfaces[surface.id] = &surface;
  int on = 0, all = 0;
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    const Eigen::Vector3d x = frame.cloud.points[i].cast<double>();
    REQUIRE(x.allFinite());
    if (frame.labels[i] < 0) continue;
    REQUIRE(surfaces.count(frame.labels[i]) == 1);
    const TrueSurface& surface = *surfaces[frame.labels[i]];
    const double noise = scene::depth_noise(frame.noise, x.z());
    const Eigen::Vector3d g = surface.Q_C.gradient(x).normalized();
    ++all;
    on += std::abs(surface.Q_C.distance(x)) < 5.0 * noise &&
          std::abs(g.dot(frame.normals[i].cast<double>())) > 0.9 &&
          surface.box_S.exteriorDistance(surface.X_CS.inverse() * x) < 0.02;
  }
  CHECK(all > 100000);
  CHECK(on > 0.97 * all);
}

}  // namespace
}  // namespace quadrille::scoring

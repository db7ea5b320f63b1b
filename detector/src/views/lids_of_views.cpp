#include "views/lids_of_views.hpp"

#include <cstddef>

#include "surfaces/lid.hpp"

namespace quadrille {
namespace {

// Points are looked at as far as this many cells beside a lid's cells.
constexpr double kMarginCells = 3.0;

}  // namespace

std::vector<OutlinePoint> outline_of_lids(const Surface& surface, const Scene& scene) {
  std::vector<OutlinePoint> outline;
  const Family family = surface.fit.family;
  if (family != Family::kCylinder && family != Family::kEllipticCylinder) return outline;
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    const ViewCells& view = scene.views[v];
    if (!view.has_points()) continue;
    for (const Lid& lid : find_lids(surface, scene.finest, scene.context.sights[v])) {
      const DirectionIndex& index = view.directions->index();
      const std::vector<OutlinePoint> own =
          outline_of(lid, index.points_towards(lid.places_C, kMarginCells * lid.cell), index.eye());
      outline.insert(outline.end(), own.begin(), own.end());
    }
  }
  return outline;
}

}  // namespace quadrille

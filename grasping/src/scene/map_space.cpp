#include "scene/map_space.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

#include "quadrille/detector/vector_clones.hpp"
#include "scene/free_supports.hpp"
#include "space/evidence.hpp"
#include "space/map_limits.hpp"
#include "space/space_mapper.hpp"
#include "space/surface_cover.hpp"

namespace quadrille {
namespace {

// Number of points that are looked at together. They follow each other in the picture, and mostly
// all of them lie in the region around the targets.
constexpr int kAtOnce = 16;

/// Returns the resolution [m] at which the region around all targets is mapped, and warns if it is
/// coarser than asked for.
double resolution_for(const Eigen::AlignedBox3d& region, SceneParts* parts) {
  const double wanted = parts->options.resolution;
  if (region.isEmpty()) return wanted;
  const double resolution = fit_resolution(region, wanted);
  if (resolution > wanted) {
    std::ostringstream text;
    text << std::setprecision(3) << "the targets lie far apart: occupancy is mapped at "
         << 1000.0 * resolution << " mm in place of " << 1000.0 * wanted
         << " mm; crop the cloud for a finer map";
    parts->warnings.push_back(text.str());
  }
  return resolution;
}

/// Marks the strays of a view, and the points that show what views before it show.
std::vector<std::uint8_t> without_repeats(const DepthView& view,
                                          const std::vector<Eigen::Vector3f>& points,
                                          const SurfaceCover& before, bool first) {
  std::vector<std::uint8_t> left_out = view.stray();
  if (first) return left_out;
  for (std::size_t n = 0; n < points.size(); ++n) left_out[n] |= before.covers(points[n]);
  return left_out;
}

/// Returns true if all points lie in a region and none is left out.
QUADRILLE_VECTOR_CLONES
bool all_kept(const float* x, const std::uint8_t* left_out, const float* low, const float* high) {
  int kept = 1;
  // The bounds are repeated for each point.
  for (std::size_t n = 0; n < std::size_t{3} * kAtOnce; ++n) {
    kept &= static_cast<int>(x[n] >= low[n]) & static_cast<int>(x[n] <= high[n]);
  }
  int left = 0;
  for (std::size_t n = 0; n < kAtOnce; ++n) left |= left_out[n];
  return kept != 0 && left == 0;
}

/// The points of all views that lie in the region around the targets, with the index of the view of
/// each, and those beside it that the blocks of the map hold.
struct KeptPoints {
  std::vector<Eigen::Vector3f> p_C, beside_C;
  std::vector<int> view;
};

/// Keeps the points of a view that lie in a region, and those in the blocks of the map about it.
void keep_points(const std::vector<Eigen::Vector3f>& points, std::size_t view,
                 const Eigen::AlignedBox3f& region, const Eigen::AlignedBox3f& blocks,
                 const std::vector<std::uint8_t>& left_out, KeptPoints* kept) {
  using Bounds = Eigen::Matrix<float, 3, kAtOnce>;
  const Bounds low = region.min().replicate<1, kAtOnce>(),
               high = region.max().replicate<1, kAtOnce>();
  std::vector<Eigen::Vector3f>& p_C = kept->p_C;
  p_C.reserve(p_C.size() + points.size());
  for (std::size_t first = 0; first < points.size(); first += kAtOnce) {
    const std::size_t end = std::min(first + kAtOnce, points.size());
    const Eigen::Vector3f* from = points.data();
    const std::uint8_t* left = left_out.data();
    if (end - first == kAtOnce &&
        all_kept(from[first].data(), left + first, low.data(), high.data())) {
      p_C.insert(p_C.end(), from + first, from + end);
      continue;
    }
    for (std::size_t n = first; n < end; ++n) {
      if (left[n]) continue;
      if (region.contains(from[n])) {
        p_C.push_back(from[n]);
      } else if (blocks.contains(from[n])) {
        kept->beside_C.push_back(from[n]);
      }
    }
  }
  kept->view.resize(p_C.size(), static_cast<int>(view));
}

/// Adds the points of all views to the map, and keeps those around the targets.
/// @return the points in the map that are not around the targets
std::vector<Eigen::Vector3f> add_views(const ViewClouds& views, const Eigen::AlignedBox3d& region,
                                       SpaceMapper* mapper, SceneParts* parts) {
  KeptPoints kept;
  // A single view has nothing to repeat.
  SurfaceCover cover(views.size() > 1 ? region : Eigen::AlignedBox3d(), mapper->resolution());
  for (std::size_t v = 0; v < views.size(); ++v) {
    const PointCloud& things = *views[v].things;
    const std::vector<std::uint8_t> left_out =
        without_repeats(parts->views[v], things.points, cover, v == 0);
    mapper->add_points(things, left_out);
    keep_points(things.points, v, region.cast<float>(), mapper->bounds().cast<float>(), left_out,
                &kept);
    if (v + 1 < views.size()) cover.add(things.points, left_out);
  }
  ViewedPoints& points = parts->points;
  points.shared_C = std::make_shared<const std::vector<Eigen::Vector3f>>(std::move(kept.p_C));
  points.p_C = *points.shared_C;
  points.view = std::move(kept.view);
  points.runs = CloudRuns(points.p_C);
  return std::move(kept.beside_C);
}

/// Returns the normal of the first support; zero if no space is to be cleared above it.
Eigen::Vector3d up_to_clear(const SceneParts& parts) {
  const auto standing = std::find_if(parts.targets.begin(), parts.targets.end(),
                                     [](const Target& target) { return !target.supports.empty(); });
  const bool clears = parts.options.clear_above && parts.views.front().valid();
  return clears && standing != parts.targets.end() ? standing->up_C() : Eigen::Vector3d::Zero();
}

}  // namespace

void map_space(const ViewClouds& views, const Surroundings& known, SceneParts* parts) {
  Eigen::AlignedBox3d region;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Target& target : parts->targets) {
    region.extend(around(target.body, parts->reach));
    boxes.push_back(around(target.body, parts->reach + kMaxClearance));
  }
  SpaceMapper mapper(region, resolution_for(region, parts), std::move(boxes),
                     parts->options.threads);
  std::vector<Eigen::Vector3f> beside_C = add_views(views, region, &mapper, parts);
  const bool occupied_by_map = known.map.tree && mapper.add(known.map);
  for (const SolidShape& shape : known.robot.shapes) {
    mapper.free_within(NearShape(shape, known.robot.padding));
  }
  parts->space = std::make_shared<OccupancyGrid>(std::move(mapper).take_on_demand(
      parts->shared_views, up_to_clear(*parts),
      {parts->points.shared_C, std::move(beside_C), known.map, known.robot}));
  if (parts->targets.empty()) return;
  parts->surfaces = TargetSurfaces(parts->targets);
  const UnknownPolicy unknown = parts->options.unknown;
  parts->map.emplace(*parts->space,
                     unknown == UnknownPolicy::kObstacle || unknown == UnknownPolicy::kTargetShadow,
                     parts->views, !occupied_by_map);
  if (occupied_by_map) {
    parts->known_map = TurnedMap::of(known.map, *parts->space, known.robot);
    if (TurnedMap::is_too_fine(known.map, *parts->space)) {
      parts->warnings.push_back(
          "the voxels of the given map are too small for the space about the targets; hands keep "
          "off the plan's voxels that hold some of them, but may touch others at their corners");
    }
  }
  // The map of others shows no points of its own, so that nothing tells what its voxels hold.
  if (!occupied_by_map) free_supports(parts, &*parts->map);
}

}  // namespace quadrille

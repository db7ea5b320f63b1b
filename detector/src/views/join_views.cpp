#include "views/join_views.hpp"

#include <utility>

#include "surfaces/aggregate.hpp"
#include "views/joined_samples.hpp"
#include "views/unite_planes.hpp"

namespace quadrille {
namespace {

// Standard deviation of what is left of the errors of poses after the views were aligned [m].
constexpr double kViewShift = 0.0007;

/// The numbers of a view's samples among the samples of all views.
std::vector<int> shifted(std::vector<int> region, int first_sample) {
  for (int& i : region) i += first_sample;
  return region;
}

/// The plane of a flat surface, with its normal towards the side that was seen.
Eigen::Vector4d plane_of(const Surface& flat, const SurfaceSamples& samples) {
  const Vector10d q = flat.Q.coefficients();
  Eigen::Vector4d plane(2.0 * q[6], 2.0 * q[7], 2.0 * q[8], q[9]);
  plane /= plane.head<3>().norm();
  const Eigen::Vector3d seen = samples.n[flat.region.front()].cast<double>();
  return plane.head<3>().dot(seen) < 0.0 ? Eigen::Vector4d(-plane) : plane;
}

/// The parts of all views that are still to be joined.
struct Parts {
  std::vector<const SurfaceSamples*> coarse, finest;
  std::vector<int> first_coarse_cells, first_cells;
  std::vector<PlaneRegion> planes, flats;
  std::vector<Candidate> candidates;
};

Parts parts_of(const std::vector<Scene>& views) {
  Parts parts;
  int coarse_samples = 0, samples = 0, coarse_cells = 0, cells = 0;
  for (const Scene& view : views) {
    parts.coarse.push_back(&view.coarse);
    parts.finest.push_back(&view.finest);
    parts.first_coarse_cells.push_back(coarse_cells);
    parts.first_cells.push_back(cells);
    for (const PlaneRegion& plane : view.planes) {
      parts.planes.push_back({plane.plane, shifted(plane.samples, coarse_samples)});
    }
    for (const Surface& surface : view.surfaces) {
      std::vector<int> region = shifted(surface.region, samples);
      if (is_flat(surface)) {
        parts.flats.push_back({plane_of(surface, view.finest), std::move(region)});
      } else {
        parts.candidates.push_back({surface.Q, surface.fit.family, std::move(region), surface.rms});
      }
    }
    const CellPyramid& pyramid = *view.views.front().pyramid;
    coarse_samples += view.coarse.size();
    samples += view.finest.size();
    coarse_cells += pyramid.size(kLevels - 1);
    cells += pyramid.size(0);
  }
  return parts;
}

/// Chooses among the surfaces of all views.
std::vector<Surface> choose_surfaces(const Scene& scene, Parts parts,
                                     const DetectorOptions& options) {
  Aggregation chosen(scene.finest, options.aggregate, options.inlier, scene.context);
  chosen.offer(std::move(parts.candidates), SearchLevel::kFinest);
  for (PlaneRegion& flat : parts.flats) {
    std::erase_if(flat.samples, [&](int i) { return !chosen.free()[i]; });
  }
  std::erase_if(parts.flats, [](const PlaneRegion& flat) { return flat.samples.empty(); });
  chosen.offer_planes(unite_planes(scene.finest, std::move(parts.flats)).planes);
  return chosen.surfaces();
}

}  // namespace

Scene join_views(std::vector<Scene> views, const DetectorOptions& options) {
  if (views.size() == 1) return std::move(views.front());
  Scene scene;
  Parts parts = parts_of(views);
  scene.coarse = joined_samples(parts.coarse, parts.first_coarse_cells, kViewShift);
  scene.finest = joined_samples(parts.finest, parts.first_cells, kViewShift);
  UnitedPlanes united = unite_planes(scene.coarse, std::move(parts.planes));
  scene.planes = std::move(united.planes);
  scene.context.up = normal_of_largest(scene.planes);
  auto number = united.number.begin();
  for (std::size_t v = 0; v < views.size(); ++v) {
    for (const int k : views[v].plane_of_cell) {
      scene.plane_of_cell.push_back(k < 0 ? k : *(number + k));
    }
    number += static_cast<std::ptrdiff_t>(views[v].planes.size());
    scene.context.sights.push_back(std::move(views[v].context.sights.front()));
    ViewCells& cells = scene.views.emplace_back(std::move(views[v].views.front()));
    cells.first = parts.first_cells[v];
  }
  scene.surfaces = choose_surfaces(scene, std::move(parts), options);
  return scene;
}

}  // namespace quadrille

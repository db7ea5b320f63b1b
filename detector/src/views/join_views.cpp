#include "views/join_views.hpp"

#include <utility>

#include "surfaces/aggregate.hpp"
#include "views/joined_samples.hpp"
#include "views/own_surfaces.hpp"
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

/// The parts of all views, whose regions refer to the samples of all views.
struct AllParts {
  std::vector<const SurfaceSamples*> coarse, finest;
  std::vector<int> first_coarse_cells, first_cells;
  std::vector<PlaneRegion> planes, flats;
  std::vector<Candidate> candidates;
};

AllParts all_parts(const std::vector<SceneView>& views) {
  AllParts all;
  int coarse_samples = 0, samples = 0, coarse_cells = 0, cells = 0;
  for (const SceneView& view : views) {
    const ViewParts& parts = view.parts;
    all.coarse.push_back(&parts.coarse);
    all.finest.push_back(&parts.finest);
    all.first_coarse_cells.push_back(coarse_cells);
    all.first_cells.push_back(cells);
    for (const PlaneRegion& plane : parts.planes) {
      all.planes.push_back({plane.plane, shifted(plane.samples, coarse_samples)});
    }
    for (const PlaneRegion& flat : parts.flats) {
      all.flats.push_back({flat.plane, shifted(flat.samples, samples)});
    }
    for (const Candidate& candidate : parts.candidates) {
      all.candidates.push_back(candidate);
      all.candidates.back().region = shifted(candidate.region, samples);
    }
    coarse_samples += parts.coarse.size();
    samples += parts.finest.size();
    coarse_cells +=
        view.cells.has_points() ? view.cells.pyramid->size(kLevels - 1) : parts.coarse.size();
    cells += view.cells.size();
  }
  return all;
}

/// Chooses among the surfaces of all views.
std::vector<Surface> choose_surfaces(const Scene& scene, AllParts parts,
                                     const DetectorOptions& options) {
  Aggregation chosen(scene.finest, options.aggregate, options.inlier, scene.context, {},
                     options.threads);
  const OwnSurfaces own(scene.finest, parts.candidates);
  chosen.offer(std::move(parts.candidates), SearchLevel::kFinest,
               [&](const Surface& surface) { return own.tell_apart(surface.region); });
  for (PlaneRegion& flat : parts.flats) {
    std::erase_if(flat.samples, [&](int i) { return !chosen.free()[i]; });
  }
  std::erase_if(parts.flats, [](const PlaneRegion& flat) { return flat.samples.empty(); });
  chosen.offer_planes(unite_planes(scene.finest, std::move(parts.flats)).planes);
  return chosen.surfaces();
}

}  // namespace

SceneView single_view(Scene scene) {
  ViewParts parts = parts_of(scene);
  return {std::move(scene.views.front()), std::move(parts),
          std::move(scene.context.sights.front())};
}

Scene join_views(std::vector<SceneView> views, const DetectorOptions& options) {
  Scene scene;
  AllParts parts = all_parts(views);
  scene.coarse = joined_samples(parts.coarse, parts.first_coarse_cells, kViewShift);
  scene.finest = joined_samples(parts.finest, parts.first_cells, kViewShift);
  UnitedPlanes united = unite_planes(scene.coarse, std::move(parts.planes));
  scene.planes = std::move(united.planes);
  scene.context.up = normal_of_largest(scene.planes);
  auto number = united.number.begin();
  for (std::size_t v = 0; v < views.size(); ++v) {
    for (const int k : views[v].parts.plane_of_cell) {
      scene.plane_of_cell.push_back(k < 0 ? k : *(number + k));
    }
    number += static_cast<std::ptrdiff_t>(views[v].parts.planes.size());
    scene.context.sights.push_back(std::move(views[v].sight));
    ViewCells& cells = scene.views.emplace_back(std::move(views[v].cells));
    cells.first = parts.first_cells[v];
  }
  scene.surfaces = choose_surfaces(scene, std::move(parts), options);
  return scene;
}

Scene join_scenes(std::vector<Scene> scenes, const DetectorOptions& options) {
  if (scenes.size() == 1) return std::move(scenes.front());
  std::vector<SceneView> views;
  views.reserve(scenes.size());
  for (Scene& scene : scenes) views.push_back(single_view(std::move(scene)));
  return join_views(std::move(views), options);
}

}  // namespace quadrille

#include "views/findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "bodies/close_lengths.hpp"
#include "bodies/common_axis.hpp"
#include "bodies/expect_usual_walls.hpp"
#include "bodies/find_bodies.hpp"
#include "bodies/upright_cones.hpp"
#include "bodies/walls.hpp"
#include "boxes/box_hints.hpp"
#include "boxes/find_boxes.hpp"
#include "boxes/join_boxes.hpp"
#include "boxes/numbered_boxes.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "samples/cell_scatter.hpp"
#include "surfaces/heap.hpp"
#include "surfaces/last_fit.hpp"
#include "surfaces/measure.hpp"
#include "surfaces/plane_surface.hpp"
#include "surfaces/point_rms.hpp"
#include "surfaces/sensor_correlation.hpp"
#include "views/body_views.hpp"
#include "views/joined_samples.hpp"
#include "views/lids_of_views.hpp"
#include "views/seen_through.hpp"

namespace quadrille {
namespace {

/// True if the list of types is empty or contains this type.
bool lets_pass(const std::vector<QuadricType>& types, QuadricType type) {
  return types.empty() || std::find(types.begin(), types.end(), type) != types.end();
}

/// True if a plane may be a piece that sensor waves have cut off a larger plane: one of the planes
/// before it, which are larger, is parallel to it within 20°.
bool has_larger_parallel(const std::vector<PlaneRegion>& planes, std::size_t k) {
  constexpr double kMinCosine = 0.94;
  return std::any_of(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(k),
                     [&](const PlaneRegion& larger) {
                       return std::abs(larger.plane.head<3>().dot(planes[k].plane.head<3>())) >
                              kMinCosine;
                     });
}

/// True if a view sees through a sample of another one.
bool is_contradicted(const SurfaceSamples& samples, int i, const std::vector<Sight>& sights) {
  for (std::size_t v = 0; v < sights.size() && sights.size() > 1; ++v) {
    if (v != samples.view_of(i) && sees_through(sights[v], samples.raw[i], kAtFoot)) return true;
  }
  return false;
}

/// The cells of a view in a list of something for each cell of all views.
std::span<const int> part_of(std::span<const int> all, const ViewCells& view) {
  return all.subspan(static_cast<std::size_t>(view.first), static_cast<std::size_t>(view.size()));
}

/// The detections, and for each finest cell the index of the detection on which it lies, −1 for
/// none.
struct Measured {
  std::vector<Detection> detections;
  std::vector<int> owner;
  /// For each plane of the scene the index of its detection, −1 for none.
  std::vector<int> of_plane;
  /// Places on the planes, by the indices of their detections.
  PlacesOnPlanes places;
  /// Walls, by the indices of their sides' detections.
  std::vector<SeenWall> walls;
};

/// The covariance of the points in the cell of each finest sample [m²]; zero for samples that are
/// not asked for.
/// @param sample_of  for each finest cell of all views, its sample; −1 for none
std::vector<Eigen::Matrix3f> scatter_of(const Scene& scene, const std::vector<int>& sample_of) {
  std::vector<Eigen::Matrix3f> scatter(scene.finest.p.size(), Eigen::Matrix3f::Zero());
  for (const ViewCells& view : scene.views) {
    const std::span<const int> samples = part_of(sample_of, view);
    if (view.has_points()) {
      scatter_in_cells(view.cloud, *view.pyramid, samples, &scatter);
      continue;
    }
    for (std::size_t c = 0; c < samples.size(); ++c) {
      if (samples[c] >= 0) scatter[samples[c]] = view.scatter[c];
    }
  }
  return scatter;
}

/// The planes of a scene as detections; nullopt for those that are doubtful.
std::vector<std::optional<Detection>> measured_planes(const Scene& scene, double min_confidence) {
  const std::vector<Surface> weighed = weighed_planes(scene.coarse, scene.planes, scene.context);
  std::vector<std::optional<Detection>> planes(weighed.size());
  for (std::size_t k = 0; k < weighed.size(); ++k) {
    const bool doubtful = weighed[k].confidence < min_confidence;
    if (doubtful && has_larger_parallel(scene.planes, k)) continue;
    planes[k] = measure(weighed[k], scene.coarse, scene.viewpoint());
  }
  return planes;
}

/// Returns the surfaces that are neither part of a plane nor heaps on one, and gives them their
/// cells.
/// @param sample_of  receives for each finest cell of all views its sample on a surface
std::vector<Surface> surfaces_off_planes(const Scene& scene, Measured* measured,
                                         std::vector<int>* sample_of) {
  std::vector<Surface> surfaces;
  for (const Surface& surface : scene.surfaces) {
    if (is_flat(surface) && is_part_of(surface, scene.finest, scene.planes, scene.coarse)) continue;
    if (scene.context.up &&
        is_heap(surface, scene.finest, scene.planes, scene.coarse, *scene.context.up)) {
      continue;
    }
    for (const int i : surface.region) {
      const int cell = scene.finest.source[i];
      measured->owner[cell] = static_cast<int>(surfaces.size());
      (*sample_of)[cell] = i;
    }
    surfaces.push_back(surface);
  }
  return surfaces;
}

/// Adds the planes, and gives them those of their cells that no surface has.
void add_planes(const Scene& scene, std::vector<std::optional<Detection>> planes,
                Measured* measured) {
  std::vector<int>& of_plane = measured->of_plane;
  of_plane.assign(planes.size(), -1);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (!planes[k]) continue;
    of_plane[k] = static_cast<int>(measured->detections.size());
    std::vector<std::vector<Eigen::Vector3d>>& places = measured->places[of_plane[k]];
    places.resize(scene.views.size());
    for (const int i : scene.planes[k].samples) {
      places[scene.coarse.view_of(i)].push_back(scene.coarse.raw[i].cast<double>());
    }
    measured->detections.push_back(std::move(*planes[k]));
  }
  for (std::size_t c = 0; c < measured->owner.size(); ++c) {
    const int plane = scene.plane_of_cell[c];
    if (measured->owner[c] < 0 && plane >= 0) measured->owner[c] = of_plane[plane];
  }
}

/// Measures the surfaces and planes of a scene.
Measured measure_all(const Scene& scene, const DetectorOptions& options) {
  Measured measured{{}, std::vector<int>(scene.plane_of_cell.size(), -1), {}, {}, {}};
  std::vector<int> sample_of(measured.owner.size(), -1);
  std::vector<Surface> surfaces = surfaces_off_planes(scene, &measured, &sample_of);
  share_correlation(&surfaces);

  const bool seeks_planes = lets_pass(options.only, QuadricType::kPlane);
  std::vector<std::optional<Detection>> planes;
  std::vector<Eigen::Matrix3f> scatter;
  parallel_for(2, options.threads, [&](int task) {
    if (task == 1) {
      scatter = scatter_of(scene, sample_of);
    } else if (seeks_planes) {
      planes = measured_planes(scene, options.aggregate.min_plane_confidence);
    }
  });

  const bool seeks_cylinders = lets_pass(options.only, QuadricType::kCylinder) ||
                               lets_pass(options.only, QuadricType::kEllipticCylinder);
  const std::vector<Sight>& sights = scene.context.sights;
  measured.detections.resize(surfaces.size());
  std::vector<LastFit> fits(surfaces.size());
  parallel_for(static_cast<int>(surfaces.size()), options.threads, [&](int k) {
    std::vector<OutlinePoint> outline;
    if (seeks_cylinders) outline = outline_of_lids(surfaces[k], scene);
    fits[k] = last_fit(surfaces[k], scene.finest, scatter, sights, outline);
    measured.detections[k] = measure(fits[k].surface, scene.finest, scene.viewpoint(), sights);
  });
  const auto measure_anew = [&](std::span<const int> changed) {
    for (const int k : changed) {
      measured.detections[k] = measure(fits[k].surface, scene.finest, scene.viewpoint(), sights);
    }
  };
  if (scene.context.up) measure_anew(stand_cones_up(*scene.context.up, &fits));
  std::vector<CommonAxis> axes = fit_common_axes(measured.detections, &fits);
  for (const CommonAxis& axis : axes) measure_anew(axis.members);
  std::vector<WallGap> gaps = find_gaps(measured.detections, fits, scene.finest, axes);
  measure_anew(expect_usual_walls(scene.finest, &gaps, &axes, &fits));
  close_lengths(fits, scene.finest, axes, &measured.detections);
  measured.walls = seen_walls(gaps);
  if (seeks_planes) add_planes(scene, std::move(planes), &measured);
  return measured;
}

/// Replaces the rms of the samples by the rms of the points, where there are enough.
void set_rms_of_points(const Scene& scene, Measured* measured) {
  std::vector<Quadric> quadrics;
  for (const Detection& d : measured->detections) quadrics.push_back(d.Q_C);
  PointRms of_points(quadrics);
  for (const ViewCells& view : scene.views) {
    if (!view.has_points()) continue;
    of_points.add(view.cloud, *view.pyramid, part_of(measured->owner, view));
  }
  const std::vector<double> rms = of_points.values();
  for (std::size_t k = 0; k < rms.size(); ++k) {
    if (std::isfinite(rms[k])) measured->detections[k].rms = rms[k];
  }
}

/// Sorts detections by score and then by size, those to report first, and numbers them.
/// @param ids  receives for each detection, by its id before, the new id
std::vector<Detection> ranked(std::vector<Detection> detections,
                              const std::vector<QuadricType>& report, std::vector<int>* ids) {
  std::stable_sort(detections.begin(), detections.end(),
                   [](const Detection& a, const Detection& b) {
                     return a.score != b.score ? a.score > b.score : a.inliers > b.inliers;
                   });
  const auto others =
      std::stable_partition(detections.begin(), detections.end(),
                            [&](const Detection& d) { return lets_pass(report, d.type); });
  int id = 0;
  const auto number = [&](Detection& d, int next) { d.id = (*ids)[d.id] = next; };
  for (auto d = detections.begin(); d != others; ++d) number(*d, ++id);
  id = 0;
  for (auto d = others; d != detections.end(); ++d) number(*d, --id);
  return detections;
}

/// Owner of samples on surfaces of types that are not asked for.
constexpr int kNotAsked = std::numeric_limits<int>::min();

std::size_t count_points(const Scene& scene) {
  std::size_t count = 0;
  for (const ViewCells& view : scene.views) {
    const int size = view.has_points() ? view.size() : 0;
    for (int c = 0; c < size; ++c) {
      count += static_cast<std::size_t>(view.pyramid->count(c));
    }
  }
  return count;
}

/// Finds boxes in each view, in which all detections are known, and joins them.
/// @param owner        for each sample the id of the detection on which it lies
/// @param unexplained  nonzero for samples that lie on no detection
std::vector<Box> boxes_of(const Scene& scene, const std::vector<Detection>& detections,
                          const std::vector<int>& owner, const Mask& unexplained,
                          const DetectorOptions& options) {
  const bool seeks_faces = lets_pass(options.only, QuadricType::kPlane) &&
                           lets_pass(options.report, QuadricType::kPlane);
  std::vector<std::vector<Box>> of_views;
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    const ViewCells& view = scene.views[v];
    if (!view.has_points()) {
      of_views.push_back(numbered_boxes(view.boxes, detections));
      continue;
    }
    Mask free = unexplained;
    for (int i = 0; i < scene.finest.size(); ++i) {
      if (scene.finest.view_of(i) != v) free[i] = 0;
    }
    BoxHints hints;
    if (seeks_faces) {
      hints = find_box_hints(scene.finest, options.planes, free, detections, owner, v);
    }
    of_views.push_back(find_boxes(*view.directions, detections, hints, options.threads));
  }
  return join_boxes(std::move(of_views));
}

}  // namespace

Findings measure_scene(const Scene& scene, const DetectorOptions& options, StageClock& clock) {
  Measured measured = measure_all(scene, options);
  set_rms_of_points(scene, &measured);
  for (std::size_t k = 0; k < measured.detections.size(); ++k) {
    measured.detections[k].id = static_cast<int>(k);
  }
  std::vector<int> ids(measured.detections.size(), 0);
  std::erase_if(measured.detections,
                [&](const Detection& d) { return !lets_pass(options.only, d.type); });
  Findings findings;
  findings.detections = ranked(std::move(measured.detections), options.report, &ids);
  findings.points_used = count_points(scene);
  clock.end("measure");

  std::vector<int> owner;
  Mask unexplained;
  for (int i = 0; i < scene.finest.size(); ++i) {
    const int k = measured.owner[scene.finest.source[i]];
    // A sample that another view sees through is on no surface, so it must not become a part of a
    // lump.
    if (k < 0 && is_contradicted(scene.finest, i, scene.context.sights)) {
      owner.push_back(kNotAsked);
      unexplained.push_back(0);
      continue;
    }
    // Samples on a surface of a type that was not asked for are explained by it, so they must not
    // become a lump.
    owner.push_back(k < 0 ? 0 : ids[k] == 0 ? kNotAsked : ids[k]);
    unexplained.push_back(k < 0);
  }
  findings.boxes = boxes_of(scene, findings.detections, owner, unexplained, options);
  clock.end("boxes");
  const bool all_types = options.only.empty() && options.report.empty();
  PlacesOnPlanes places;
  for (auto& [index, of_plane] : measured.places) places[ids[index]] = std::move(of_plane);
  for (SeenWall& wall : measured.walls) {
    wall.outer = ids[wall.outer], wall.inner = ids[wall.inner];
  }
  std::optional<SurfaceSamples> linked;
  if (scene.views.size() > 1) linked = linked_views(scene.finest, unexplained);
  findings.bodies =
      find_bodies({findings.detections, findings.boxes, linked ? *linked : scene.finest, owner,
                   places, measured.walls, all_types});
  if (scene.views.size() > 1 || !scene.views.front().has_points()) {
    for (int& k : measured.of_plane) k = k < 0 ? 0 : ids[k];
    note_views(scene, owner, measured.of_plane, &findings.bodies);
  }
  clock.end("bodies");
  return findings;
}

}  // namespace quadrille

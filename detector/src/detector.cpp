#include "quadrille/detector/detector.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "base/stage_clock.hpp"
#include "bodies/find_bodies.hpp"
#include "boxes/find_boxes.hpp"
#include "boxes/flat_patches.hpp"
#include "cloud/cloud_check.hpp"
#include "cloud/far_cloud.hpp"
#include "detect_with.hpp"
#include "planes/plane_claims.hpp"
#include "planes/planes.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "samples/cell_scatter.hpp"
#include "samples/sample_tree.hpp"
#include "surfaces/find_surfaces.hpp"
#include "surfaces/last_fit.hpp"
#include "surfaces/measure.hpp"
#include "surfaces/plane_surface.hpp"
#include "surfaces/point_rms.hpp"

namespace quadrille {
namespace {

/// True if the list of types is empty or contains this type.
bool lets_pass(const std::vector<QuadricType>& types, QuadricType type) {
  return types.empty() || std::find(types.begin(), types.end(), type) != types.end();
}

/// The planes, the samples on which they were found, and for each finest cell its plane, −1 for
/// none.
struct FlatParts {
  SurfaceSamples coarse;
  std::vector<PlaneRegion> planes;
  std::vector<int> plane_of_cell;
};

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

/// The detections, and for each finest cell the index of the detection on which it lies, −1 for
/// none.
struct Measured {
  std::vector<Detection> detections;
  std::vector<int> owner;
  /// For each plane, by the index of its detection, places on it [m].
  std::map<int, std::vector<Eigen::Vector3d>> places;
};

void measure_surfaces(const CloudView& cloud, const CellPyramid& pyramid,
                      const Aggregation& aggregation, const FlatParts& flat,
                      const SurfaceSamples& finest, const Sight& sight, Measured* measured) {
  std::vector<Surface> surfaces;
  for (const Surface& surface : aggregation.surfaces()) {
    if (is_flat(surface) && is_part_of(surface, finest, flat.planes, flat.coarse)) continue;
    for (const int i : surface.region) {
      measured->owner[finest.source[i]] = static_cast<int>(surfaces.size());
    }
    surfaces.push_back(surface);
  }
  const std::vector<Eigen::Matrix3f> scatter = scatter_in_cells(cloud, pyramid, measured->owner);
  for (Surface& surface : surfaces) {
    surface = last_fit(std::move(surface), finest, scatter, sight);
    measured->detections.push_back(measure(surface, finest, cloud.viewpoint, sight));
  }
}

/// Measures the planes, and gives them those of their cells that no surface has.
void measure_planes(const FlatParts& flat, const SceneContext& context, double min_confidence,
                    const Eigen::Vector3d& viewpoint, Measured* measured) {
  const std::vector<Surface> weighed = weighed_planes(flat.coarse, flat.planes, context);
  std::vector<int> of_plane(flat.planes.size(), -1);
  for (std::size_t k = 0; k < flat.planes.size(); ++k) {
    const bool doubtful = weighed[k].confidence < min_confidence;
    if (doubtful && has_larger_parallel(flat.planes, k)) continue;
    of_plane[k] = static_cast<int>(measured->detections.size());
    for (const int i : flat.planes[k].samples) {
      measured->places[of_plane[k]].push_back(flat.coarse.raw[i].cast<double>());
    }
    measured->detections.push_back(measure(weighed[k], flat.coarse, viewpoint));
  }
  for (std::size_t c = 0; c < measured->owner.size(); ++c) {
    const int plane = flat.plane_of_cell[c];
    if (measured->owner[c] < 0 && plane >= 0) measured->owner[c] = of_plane[plane];
  }
}

/// Replaces the rms of the samples by the rms of the points.
void set_rms_of_points(const CloudView& cloud, const CellPyramid& pyramid, Measured* measured) {
  std::vector<Quadric> quadrics;
  for (const Detection& d : measured->detections) quadrics.push_back(d.Q_C);
  const std::vector<double> rms = rms_of_points(cloud, pyramid, measured->owner, quadrics);
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

/// Result of all stages on a cloud.
struct Findings {
  std::vector<Detection> detections;
  std::vector<Box> boxes;
  std::vector<SceneBody> bodies;
  std::size_t points_used = 0;
};

std::size_t count_points(const CellPyramid& pyramid) {
  std::size_t count = 0;
  for (int c = 0; c < pyramid.size(0); ++c) count += static_cast<std::size_t>(pyramid.count(c));
  return count;
}

/// Runs all stages on a cloud near the origin.
Findings find_all(const CloudView& cloud, const DetectorOptions& options,
                  const FindCandidates& find, StageClock& clock) {
  const std::unique_ptr<CellPyramid> pyramid = make_pyramid(cloud, options.sampling);
  clock.end("cells");
  if (!pyramid) return {};

  FlatParts flat{pyramid->coarse_samples(), {}, {}};
  flat.planes = find_planes(flat.coarse, options.planes);
  flat.plane_of_cell = planes_of_cells(*pyramid, flat.coarse, flat.planes, options.planes.sigmas);
  clock.end("planes");

  const SampleTree tree(*pyramid,
                        pyramid->samples(cells_off_planes(flat.plane_of_cell), options.threads));
  clock.end("samples");

  const SceneContext context = {normal_of_largest(flat.planes), pyramid->sight()};
  const Aggregation aggregation = find_surfaces(tree, context, options, clock, {}, find);
  Measured measured{{}, std::vector<int>(flat.plane_of_cell.size(), -1), {}};
  measure_surfaces(cloud, *pyramid, aggregation, flat, tree.finest(), context.sight, &measured);
  if (lets_pass(options.only, QuadricType::kPlane)) {
    measure_planes(flat, context, options.aggregate.min_plane_confidence, cloud.viewpoint,
                   &measured);
  }
  set_rms_of_points(cloud, *pyramid, &measured);
  for (std::size_t k = 0; k < measured.detections.size(); ++k) {
    measured.detections[k].id = static_cast<int>(k);
  }
  std::vector<int> ids(measured.detections.size(), 0);
  std::erase_if(measured.detections,
                [&](const Detection& d) { return !lets_pass(options.only, d.type); });
  Findings findings;
  findings.detections = ranked(std::move(measured.detections), options.report, &ids);
  findings.points_used = count_points(*pyramid);
  clock.end("measure");

  std::vector<int> owner;
  Mask unexplained;
  for (const int cell : tree.finest().source) {
    const int k = measured.owner[cell];
    // Samples on a surface of a type that was not asked for are explained by it, so they must not
    // become a lump.
    owner.push_back(k < 0 ? 0 : ids[k] == 0 ? kNotAsked : ids[k]);
    unexplained.push_back(k < 0);
  }
  std::vector<FlatPatch> patches;
  if (lets_pass(options.only, QuadricType::kPlane) &&
      lets_pass(options.report, QuadricType::kPlane)) {
    patches = find_flat_patches(tree.finest(), options.planes, unexplained);
  }
  findings.boxes = find_boxes(cloud, findings.detections, patches);
  clock.end("boxes");
  const bool all_types = options.only.empty() && options.report.empty();
  PlacesOnPlanes places;
  for (auto& [index, of_plane] : measured.places) places[ids[index]] = std::move(of_plane);
  findings.bodies =
      find_bodies({findings.detections, findings.boxes, tree.finest(), owner, places, all_types});
  clock.end("bodies");
  return findings;
}

/// Runs all stages on a cloud anywhere. One far from the origin is shifted first, since its
/// coordinates leave few digits for the shape.
Findings find_anywhere(const CloudView& cloud, const Eigen::Vector3d& centre,
                       const DetectorOptions& options, const FindCandidates& find,
                       StageClock& clock) {
  const Eigen::Vector3d shift = shift_to_origin(centre);
  if (shift.isZero(0.0)) return find_all(cloud, options, find, clock);
  Findings findings = find_all(translated(cloud, shift), options, find, clock);
  for (Detection& d : findings.detections) d = translated(std::move(d), -shift);
  for (Box& box : findings.boxes) box.X_CB.pretranslate(-shift);
  for (SceneBody& body : findings.bodies) body.X_CB.pretranslate(-shift);
  return findings;
}

/// Diagonal of the bounding box of the finite points [m].
double diameter_of(const CloudView& cloud) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (p.allFinite()) box.extend(p);
  }
  return box.isEmpty() ? 0.0 : static_cast<double>(box.diagonal().norm());
}

/// Resolves the options that depend on the cloud.
DetectorOptions settled(DetectorOptions options, const CloudView& cloud) {
  if (options.sampling.relative_cell > 0.0) {
    options.sampling.cell = options.sampling.relative_cell * diameter_of(cloud);
  }
  return options;
}

DetectionResult detect_checked(const CloudView& cloud, const DetectorOptions& given,
                               const FindCandidates& find, const CloudCheck& check,
                               StageClock& clock) {
  given.check();
  DetectionResult result;
  result.points_finite = check.range.near;
  result.warnings = check.warnings;
  if (!check.usable) return result;
  const DetectorOptions options = settled(given, cloud);
  Findings found = find_anywhere(cloud, check.centre, options, find, clock);
  result.detections = std::move(found.detections);
  result.boxes = std::move(found.boxes);
  result.bodies = std::move(found.bodies);
  result.points_used = found.points_used;
  const std::string doubt = contradict_viewpoint(cloud, result.detections);
  if (!doubt.empty()) result.warnings.push_back(doubt);
  clock.end("viewpoint");
  return result;
}

}  // namespace

DetectionResult detect(const CloudView& cloud, const DetectorOptions& options) {
  return detect_with({}, cloud, options);
}

DetectionResult detect_with(const FindCandidates& find, const CloudView& given,
                            const DetectorOptions& options) {
  StageClock clock;
  const CloudCheck check = check_cloud(given);
  DetectionResult result = detect_checked(check.range.kept(given), options, find, check, clock);
  result.timings = clock.timings();
  result.total_ms = clock.total_ms();
  return result;
}

}  // namespace quadrille

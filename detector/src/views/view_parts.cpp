#include "views/view_parts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "samples/cell_scatter.hpp"
#include "views/joined_samples.hpp"

namespace quadrille {
namespace {

/// The plane of a flat surface, with its normal towards the side that was seen.
Eigen::Vector4d plane_of(const Surface& flat, const SurfaceSamples& samples) {
  const Vector10d q = flat.Q.coefficients();
  Eigen::Vector4d plane(2.0 * q[6], 2.0 * q[7], 2.0 * q[8], q[9]);
  plane /= plane.head<3>().norm();
  const Eigen::Vector3d seen = samples.n[flat.region.front()].cast<double>();
  return plane.head<3>().dot(seen) < 0.0 ? Eigen::Vector4d(-plane) : plane;
}

/// Brings a plane n·x + d = 0 from frame C into frame F.
Eigen::Vector4d moved(const Eigen::Vector4d& plane, const Eigen::Isometry3d& X_FC) {
  const Eigen::Vector3d n_F = X_FC.linear() * plane.head<3>();
  return {n_F.x(), n_F.y(), n_F.z(), plane.w() - n_F.dot(X_FC.translation())};
}

template <class T>
void erase_marked(const Mask& marked, std::vector<T>* list) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < list->size(); ++k) {
    if (!marked[k]) (*list)[kept++] = std::move((*list)[k]);
  }
  list->resize(kept);
}

/// Drops the marked samples.
/// @return the new number of each sample, −1 for those that were dropped
std::vector<int> drop_samples(const Mask& dropped, SurfaceSamples* samples) {
  std::vector<int> number(dropped.size());
  int next = 0;
  for (std::size_t i = 0; i < dropped.size(); ++i) number[i] = dropped[i] ? -1 : next++;
  std::vector<int> first = {0}, neighbours;
  for (int i = 0; i < samples->size(); ++i) {
    if (dropped[i]) continue;
    for (const int j : samples->neighbours_of(i)) {
      if (number[j] >= 0) neighbours.push_back(number[j]);
    }
    first.push_back(static_cast<int>(neighbours.size()));
  }
  samples->first = std::move(first);
  samples->neighbours = std::move(neighbours);
  erase_marked(dropped, &samples->p);
  erase_marked(dropped, &samples->n);
  erase_marked(dropped, &samples->raw);
  erase_marked(dropped, &samples->sigma);
  erase_marked(dropped, &samples->cell);
  erase_marked(dropped, &samples->count);
  samples->source.resize(samples->p.size());
  std::iota(samples->source.begin(), samples->source.end(), 0);
  return number;
}

/// Renumbers the samples of a region, and leaves out those without a number.
void renumber(const std::vector<int>& number, std::vector<int>* region) {
  std::erase_if(*region, [&](int i) { return number[i] < 0; });
  for (int& i : *region) i = number[i];
}

// With fewer samples, as many as a quadric has coefficients, a surface is not determined.
constexpr std::size_t kMinSamples = 10;

bool is_open(const std::vector<int>& region) { return region.size() < kMinSamples; }

/// Drops the planes that are left with few samples, and renumbers those of the cells.
void drop_open_planes(ViewParts* parts) {
  std::vector<int> number;
  int next = 0;
  for (const PlaneRegion& plane : parts->planes) {
    number.push_back(is_open(plane.samples) ? -1 : next++);
  }
  for (int& k : parts->plane_of_cell) k = k < 0 ? k : number[k];
  std::erase_if(parts->planes, [](const PlaneRegion& plane) { return is_open(plane.samples); });
}

/// True for samples within this distance of a box's sides, or inside [m].
constexpr double kNear = 0.006;

int samples_on(const Box& box, const ViewParts& parts) {
  const Eigen::Isometry3d X_BC = box.X_CB.inverse();
  const Eigen::AlignedBox3d near_B(-0.5 * box.size - Eigen::Vector3d::Constant(kNear),
                                   0.5 * box.size + Eigen::Vector3d::Constant(kNear));
  int count = 0;
  for (const SurfaceSamples* samples : {&parts.coarse, &parts.finest}) {
    for (const Eigen::Vector3f& p : samples->raw) {
      count += near_B.contains(X_BC * p.cast<double>());
    }
  }
  return count;
}

}  // namespace

void mark_rest(const std::vector<int>& region, const Mask& seen_through, Mask* marked) {
  const auto count =
      std::count_if(region.begin(), region.end(), [&](int i) { return seen_through[i] != 0; });
  if (2 * static_cast<std::size_t>(count) <= region.size()) return;
  for (const int i : region) (*marked)[i] = 1;
}

ViewParts parts_of(const Scene& view) {
  ViewParts parts{view.coarse, view.planes, view.finest, {}, {}, view.plane_of_cell};
  for (const Surface& surface : view.surfaces) {
    if (is_flat(surface)) {
      parts.flats.push_back({plane_of(surface, view.finest), surface.region});
    } else {
      parts.candidates.push_back({surface.Q, surface.fit.family, surface.region, surface.rms});
    }
  }
  return parts;
}

KeptParts kept_parts(const Scene& view) {
  KeptParts kept{parts_of(view), {}, {}, view.viewpoint(), view.context.sights.front()};
  ViewParts& parts = kept.parts;
  const ViewCells& cells = view.views.front();
  std::vector<int> number(static_cast<std::size_t>(cells.size()), -1);
  std::vector<int> planes;
  for (int& cell : parts.finest.source) {
    const int sample = static_cast<int>(planes.size());
    number[cell] = sample;
    planes.push_back(parts.plane_of_cell[cell]);
    cell = sample;
  }
  kept.scatter.assign(planes.size(), Eigen::Matrix3f::Zero());
  scatter_in_cells(cells.cloud, *cells.pyramid, number, &kept.scatter);
  parts.plane_of_cell = std::move(planes);
  std::iota(parts.coarse.source.begin(), parts.coarse.source.end(), 0);
  return kept;
}

void keep_boxes(const std::vector<Box>& boxes, KeptParts* kept) {
  for (const Box& box : boxes) {
    if (is_reported(box)) kept->boxes.push_back({box, samples_on(box, kept->parts)});
  }
}

void KeptParts::drop(const Mask& coarse, const Mask& finest) {
  const std::vector<int> coarse_number = drop_samples(coarse, &parts.coarse);
  for (PlaneRegion& plane : parts.planes) renumber(coarse_number, &plane.samples);
  drop_open_planes(&parts);
  const std::vector<int> number = drop_samples(finest, &parts.finest);
  erase_marked(finest, &scatter);
  erase_marked(finest, &parts.plane_of_cell);
  for (PlaneRegion& flat : parts.flats) renumber(number, &flat.samples);
  for (Candidate& candidate : parts.candidates) renumber(number, &candidate.region);
  std::erase_if(parts.flats, [](const PlaneRegion& flat) { return is_open(flat.samples); });
  std::erase_if(parts.candidates, [](const Candidate& c) { return is_open(c.region); });
}

void KeptParts::drop(const Contradiction& contradiction) {
  const Mask through = contradiction.seen_through(parts.finest.raw);
  Mask finest = through;
  for (const PlaneRegion& flat : parts.flats) mark_rest(flat.samples, through, &finest);
  for (const Candidate& candidate : parts.candidates) {
    mark_rest(candidate.region, through, &finest);
  }
  contradiction.mark_behind_new(parts.finest.raw, &finest);
  drop(contradiction.of_points(parts.coarse.raw), finest);
  contradiction.clear(&sight);
}

void KeptParts::drop(const ForgottenBox& box) {
  drop(box.of_points(parts.coarse.raw, eye), box.of_points(parts.finest.raw, eye));
  box.clear(&sight);
}

std::vector<Box> KeptParts::lasting_boxes() const {
  std::vector<Box> lasting;
  for (const KeptBox& kept : boxes) {
    if (2 * samples_on(kept.box, parts) > kept.samples) lasting.push_back(kept.box);
  }
  return lasting;
}

ViewParts moved(ViewParts parts, const Eigen::Isometry3d& X_FC) {
  parts.coarse = moved(std::move(parts.coarse), X_FC);
  parts.finest = moved(std::move(parts.finest), X_FC);
  for (PlaneRegion& plane : parts.planes) plane.plane = moved(plane.plane, X_FC);
  for (PlaneRegion& flat : parts.flats) flat.plane = moved(flat.plane, X_FC);
  for (Candidate& candidate : parts.candidates) candidate.Q = candidate.Q.transformed(X_FC);
  return parts;
}

std::vector<Eigen::Matrix3f> moved(std::vector<Eigen::Matrix3f> scatter,
                                   const Eigen::Isometry3d& X_FC) {
  const Eigen::Matrix3f R = X_FC.linear().cast<float>();
  for (Eigen::Matrix3f& S : scatter) S = R * S * R.transpose();
  return scatter;
}

}  // namespace quadrille

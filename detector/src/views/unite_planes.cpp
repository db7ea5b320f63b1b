#include "views/unite_planes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <utility>

#include "surfaces/plane_surface.hpp"

namespace quadrille {
namespace {

// Planes touch if the boxes around their samples are no farther apart than this many cells.
constexpr float kTouchCells = 3.0f;

Eigen::AlignedBox3f box_of(const SurfaceSamples& samples, const PlaneRegion& plane) {
  Eigen::AlignedBox3f box;
  float cell = 0.0f;
  for (const int i : plane.samples) {
    box.extend(samples.raw[i]);
    cell = std::max(cell, samples.cell[i]);
  }
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(0.5f * kTouchCells * cell);
  return {box.min() - margin, box.max() + margin};
}

bool are_one(const SurfaceSamples& samples, const PlaneRegion& large, const PlaneRegion& small) {
  // Planes of one view are different, because it would have found them as one.
  const auto view_of = [&](const PlaneRegion& plane) {
    return samples.view_of(plane.samples.front());
  };
  return view_of(large) != view_of(small) &&
         box_of(samples, large).intersects(box_of(samples, small)) &&
         is_part_of(plane_surface(samples, small), samples, {large}, samples);
}

/// Indices of a list in the order of falling numbers of samples.
std::vector<int> largest_first(const std::vector<PlaneRegion>& planes) {
  std::vector<int> order(planes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return planes[a].samples.size() > planes[b].samples.size();
  });
  return order;
}

}  // namespace

UnitedPlanes unite_planes(const SurfaceSamples& samples, std::vector<PlaneRegion> planes) {
  std::vector<PlaneRegion> united;
  std::vector<int> host_of(planes.size());
  for (const int k : largest_first(planes)) {
    const auto host = std::find_if(united.begin(), united.end(), [&](const PlaneRegion& larger) {
      return larger.plane.head<3>().dot(planes[k].plane.head<3>()) > 0.0 &&
             are_one(samples, larger, planes[k]);
    });
    host_of[k] = static_cast<int>(host - united.begin());
    if (host == united.end()) {
      united.push_back(std::move(planes[k]));
    } else {
      const std::vector<int>& more = planes[k].samples;
      host->samples.insert(host->samples.end(), more.begin(), more.end());
    }
  }
  UnitedPlanes result;
  std::vector<int> rank(united.size());
  for (const int k : largest_first(united)) {
    rank[k] = static_cast<int>(result.planes.size());
    result.planes.push_back(std::move(united[k]));
  }
  for (const int host : host_of) result.number.push_back(rank[host]);
  return result;
}

}  // namespace quadrille

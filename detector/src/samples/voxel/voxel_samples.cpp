#include "samples/voxel/voxel_samples.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "samples/plane_moments.hpp"
#include "samples/voxel/voxel_finder.hpp"

namespace quadrille {
namespace {

// Number of neighbours of a sample, the same as in a depth grid.
constexpr int kNeighbours = 8;

SurfaceSamples room_for(std::ptrdiff_t count) {
  SurfaceSamples samples;
  const std::size_t size = static_cast<std::size_t>(count);
  for (auto* list : {&samples.p, &samples.n, &samples.raw}) list->reserve(size);
  for (auto* list : {&samples.sigma, &samples.cell}) list->reserve(size);
  for (auto* list : {&samples.count, &samples.source}) list->reserve(size);
  samples.first.reserve(size + 1);
  samples.neighbours.reserve(size * kNeighbours);
  return samples;
}

/// Converts neighbours from voxels to samples. Voxels without a normal have no sample and are
/// dropped.
void name_samples(const std::vector<int>& sample_of, SurfaceSamples* samples) {
  std::vector<int>& neighbours = samples->neighbours;
  int begin = 0, kept = 0;
  for (int i = 0; i < samples->size(); ++i) {
    const int end = samples->first[i + 1];
    for (int k = begin; k < end; ++k) {
      const int sample = sample_of[neighbours[k]];
      if (sample >= 0) neighbours[kept++] = sample;
    }
    samples->first[i + 1] = kept;
    begin = end;
  }
  neighbours.resize(static_cast<std::size_t>(kept));
}

}  // namespace

SurfaceSamples make_voxel_samples(const VoxelGrid& grid, const Mask& keep, float sigma,
                                  const Eigen::Vector3f& eye, float reach) {
  const float edge = grid.edge();
  SurfaceSamples samples = room_for(std::count_if(keep.begin(), keep.end(), std::identity()));
  samples.first.push_back(0);
  std::vector<int> sample_of(static_cast<std::size_t>(grid.size()), -1);
  std::vector<int> nearest;
  VoxelFinder finder(grid, reach * edge, keep);
  // These are voxels at first, until all samples are known.
  std::vector<int>& neighbours = samples.neighbours;
  for (int v = 0; v < grid.size(); ++v) {
    if (!keep[v]) continue;
    const Eigen::Vector3f p = grid.mean()[v];
    const PlaneMoments moments =
        finder.moments(p, kNeighbourReach * edge, kNeighbours + 1, &nearest);
    const auto plane = moments.solve();
    if (!plane) continue;
    Eigen::Vector3f n = plane->normal;
    if (n.dot(eye - p) < 0) n = -n;
    sample_of[v] = samples.size();
    samples.p.push_back(p + n * n.dot(plane->mean));
    samples.n.push_back(n);
    samples.raw.push_back(p);
    samples.sigma.push_back(sigma);
    samples.cell.push_back(edge);
    samples.count.push_back(grid.count()[v]);
    samples.source.push_back(v);
    std::copy_if(nearest.begin(), nearest.end(), std::back_inserter(neighbours),
                 [&](int other) { return other != v; });
    samples.first.push_back(static_cast<int>(neighbours.size()));
  }
  name_samples(sample_of, &samples);
  return samples;
}

}  // namespace quadrille

#include <algorithm>
#include <vector>

#include "cloud/some_points.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/voxel/voxel_grid.hpp"
#include "samples/voxel/voxel_noise.hpp"
#include "samples/voxel/voxel_samples.hpp"

namespace quadrille {
namespace {

// Radius of the windows for normals in voxels. A window that reaches the two nearest voxels on each
// side averages the noise.
constexpr float kNormalReach = 2.6f;

class VoxelPyramid : public CellPyramid {
 public:
  VoxelPyramid(const CloudView& cloud, float edge, const NoiseOptions& noise)
      : eye_(cloud.viewpoint.cast<float>()) {
    grids_.emplace_back(cloud.points, std::span<const int>{}, edge);
    for (int l = 1; l < kLevels; ++l) {
      const VoxelGrid& finer = grids_.back();
      VoxelGrid grid(finer.mean(), finer.count(), 2 * finer.edge(), &parents_.emplace_back());
      grids_.push_back(std::move(grid));
    }
    for (const VoxelGrid& grid : grids_) sigma_.push_back(measure_voxel_noise(grid, noise));
  }

  int size(int level) const override { return grids_[level].size(); }
  const std::vector<int>& parents(int level) const override { return parents_[level]; }
  int count(int cell) const override { return grids_[0].count()[cell]; }
  Eigen::Vector3f mean(int cell) const override { return grids_[0].mean()[cell]; }
  float sigma(int) const override { return sigma_[0]; }
  int cell_of(const Eigen::Vector3f& point) const override { return grids_[0].voxel_of(point); }
  /// True if the noise that averaging does not remove is large compared with the finest voxels.
  bool is_noisy(double noisiest_cell) const {
    return sigma_.back() > static_cast<float>(noisiest_cell) * grids_[0].edge();
  }

  SurfaceSamples coarse_samples() const override {
    const Mask all(static_cast<std::size_t>(grids_.back().size()), 1);
    // The smaller windows avoid edges.
    return make_voxel_samples(grids_.back(), all, sigma_.back(), eye_, kNeighbourReach);
  }

  std::vector<SurfaceSamples> samples(const Mask& keep, int threads) const override {
    std::vector<Mask> kept = {keep};
    for (int l = 1; l < kLevels; ++l) {
      // A coarse voxel is kept if most of its points are.
      std::vector<int> balance(static_cast<std::size_t>(grids_[l].size()), 0);
      for (std::size_t v = 0; v < kept[l - 1].size(); ++v) {
        const int n = grids_[l - 1].count()[v];
        balance[parents_[l - 1][v]] += kept[l - 1][v] ? n : -n;
      }
      Mask& mark = kept.emplace_back();
      for (const int b : balance) mark.push_back(b > 0);
    }
    std::vector<SurfaceSamples> result(kLevels);
    parallel_for(kLevels, threads, [&](int l) {
      result[l] = make_voxel_samples(grids_[l], kept[l], sigma_[l], eye_, kNormalReach);
      result[l].common_noise = common_share(sigma_.front(), sigma_.back());
    });
    return result;
  }

 private:
  Eigen::Vector3f eye_;
  /// One element per level, the finest first.
  std::vector<VoxelGrid> grids_;
  std::vector<float> sigma_;
  /// Per level except the last, the coarser voxel of each voxel.
  std::vector<std::vector<int>> parents_;
};

}  // namespace

std::unique_ptr<CellPyramid> make_voxel_pyramid(const CloudView& cloud,
                                                const SamplingOptions& options) {
  const auto finite = std::count_if(cloud.points.begin(), cloud.points.end(),
                                    [](const Eigen::Vector3f& p) { return p.allFinite(); });
  if (static_cast<std::size_t>(finite) < kMinPoints) return nullptr;
  const float edge = static_cast<float>(options.cell);
  auto pyramid = std::make_unique<VoxelPyramid>(cloud, edge, options.noise);
  if (pyramid->is_noisy(options.noisiest_cell)) {
    pyramid = std::make_unique<VoxelPyramid>(cloud, 2 * edge, options.noise);
  }
  return pyramid;
}

}  // namespace quadrille

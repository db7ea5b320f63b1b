#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/depth/depth_cells.hpp"
#include "samples/depth/depth_samples.hpp"

namespace quadrille {
namespace {

// A cloud is not a single view if a larger share of its cells lies within areas of layers; depth
// cameras show a tenth of this. Cells of fewer pixels hold too few points to tell.
constexpr double kMaxLayered = 0.002;
constexpr int kMinLayerPixels = 2;
// Largest edge of a cell [pixels]: an image of 640 x 480 still has 20 x 15 cells.
constexpr int kMaxCellPixels = 32;
// If the nearer points are deeper than this [m], the viewpoint is not the sensor's: a sensor that
// far away would not see the objects sought.
constexpr float kMaxNearDepth = 50.0f;
// Half windows of the regressions [cells]. The window for planes is small because they are found
// before normals have to be smooth.
constexpr int kPlaneReach = 1, kReach = 2;
// Cells have their nominal size at the depth that this many tenths of the points are nearer than;
// it is estimated from this many points.
constexpr std::size_t kNearTenths = 3, kDepths = 5000;

std::vector<int> parents_of(const DepthCells& fine, const DepthCells& coarse) {
  std::vector<int> parents;
  parents.reserve(fine.count.size());
  for (int j = 0; j < fine.height; ++j) {
    for (int i = 0; i < fine.width; ++i) parents.push_back((j / 2) * coarse.width + i / 2);
  }
  return parents;
}

class DepthPyramid : public CellPyramid {
 public:
  /// @param z  depth at which the levels' noise is compared [m]
  DepthPyramid(const PinholeView& view, std::array<DepthCells, kLevels> cells,
               std::vector<NoiseModel> noise, float z)
      : view_(view),
        X_CV_(view.X_VC.inverse()),
        cells_(std::move(cells)),
        noise_(std::move(noise)),
        common_noise_(common_share(noise_.front().sigma(z), noise_.back().sigma(z))) {
    for (int l = 0; l + 1 < kLevels; ++l) parents_[l] = parents_of(cells_[l], cells_[l + 1]);
  }

  int size(int level) const override { return cells_[level].size(); }
  const std::vector<int>& parents(int level) const override { return parents_[level]; }
  int count(int cell) const override { return cells_[0].count[cell]; }
  Eigen::Vector3f mean(int cell) const override { return X_CV_ * cells_[0].position_V(cell); }
  float sigma(int cell) const override { return noise_[0].sigma(1.0f / cells_[0].w[cell]); }
  int cell_of(const Eigen::Vector3f& point) const override {
    return cells_[0].cell_of(view_(point));
  }

  Sight sight() const override {
    const DepthCells& cells = cells_[0];
    return {view_.X_VC,  cells.image.corner, cells.pitch() * static_cast<float>(cells.pixels),
            cells.width, cells.height,       cells.w};
  }

  SurfaceSamples coarse_samples() const override {
    return make_depth_samples(cells_[kLevels - 1], {}, noise_[kLevels - 1], X_CV_, kPlaneReach);
  }

  std::vector<SurfaceSamples> samples(const std::vector<char>& keep, int threads) const override {
    std::array<DepthCells, kLevels> rest;
    for (int l = 1; l < kLevels; ++l) {
      rest[l] = l == 1 ? coarser(cells_[0], keep) : coarser(rest[l - 1], {});
    }
    std::vector<SurfaceSamples> levels(kLevels);
    parallel_for(kLevels, threads, [&](int l) {
      levels[l] = l == 0 ? make_depth_samples(cells_[0], keep, noise_[0], X_CV_, kReach)
                         : make_depth_samples(rest[l], {}, noise_[l], X_CV_, kReach);
      levels[l].common_noise = common_noise_;
    });
    return levels;
  }

 private:
  PinholeView view_;
  Eigen::Isometry3f X_CV_;
  std::array<DepthCells, kLevels> cells_;
  std::vector<NoiseModel> noise_;
  double common_noise_;
  std::array<std::vector<int>, kLevels - 1> parents_;
};

/// Depth that kNearTenths tenths of the points are nearer than [m]; 1 m if no point is seen.
float near_depth(const CloudView& cloud, const PinholeView& view) {
  std::vector<float> w;
  const std::size_t stride = std::max<std::size_t>(1, view.seen / kDepths);
  for (std::size_t i = 0; i < cloud.points.size(); i += stride) {
    const float inverse_depth = view(cloud.points[i]).z();
    if (inverse_depth > 0.0f) w.push_back(inverse_depth);
  }
  if (w.empty()) return 1.0f;
  const auto near = w.begin() + static_cast<std::ptrdiff_t>(w.size() * (10 - kNearTenths) / 10);
  std::nth_element(w.begin(), near, w.end());
  return 1.0f / *near;
}

}  // namespace

std::unique_ptr<CellPyramid> make_depth_pyramid(const CloudView& cloud,
                                                const SamplingOptions& options) {
  const std::optional<PinholeView> view = find_view(cloud, options.stride);
  if (!view) return nullptr;
  std::optional<PinholeImage> image = find_image(cloud, *view);
  if (!image) return nullptr;
  // A cell has a whole number of pixels. The camera's own pixels are finer than those of the
  // thinned cloud and allow finer steps of the cell size.
  image->pitch /= static_cast<float>(options.stride);
  image->width *= options.stride;
  image->height *= options.stride;
  const float z = near_depth(cloud, *view);
  if (z > kMaxNearDepth) return nullptr;
  const int pixels = static_cast<int>(
      std::lround(std::clamp(options.cell / (image->pitch.x() * z), 1.0, 1.0 * kMaxCellPixels)));
  std::array<DepthCells, kLevels> cells;
  cells[0] = make_depth_cells(cloud, *view, *image, pixels);
  const double layered = pixels < kMinLayerPixels
                             ? make_depth_cells(cloud, *view, *image, kMinLayerPixels).layered
                             : cells[0].layered;
  if (layered > kMaxLayered) return nullptr;
  const auto coarsen = [&] {
    for (int l = 1; l < kLevels; ++l) cells[l] = coarser(cells[l - 1], {});
  };
  coarsen();
  std::vector<NoiseModel> noise = measure_noise(cells, options.noise);
  if (noise.back().sigma(z) > options.noisiest_cell * cells[0].metric(1.0f / z)) {
    cells[0] = std::move(cells[1]);
    coarsen();
    noise = measure_noise(cells, options.noise);
  }
  return std::make_unique<DepthPyramid>(*view, std::move(cells), std::move(noise), z);
}

}  // namespace quadrille

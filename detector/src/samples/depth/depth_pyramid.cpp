#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/quantile.hpp"
#include "cloud/some_points.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/depth/coarser_cells.hpp"
#include "samples/depth/depth_cells.hpp"
#include "samples/depth/depth_samples.hpp"

namespace quadrille {
namespace {

// A cloud is not a single view if a larger share of its cells lies within areas of layers; depth
// cameras show a tenth of this.
constexpr double kMaxLayered = 0.002;
// Half windows of the regressions [cells]. The window for planes is small because they are found
// before normals have to be smooth.
constexpr int kPlaneReach = 1, kReach = 2;

std::vector<int> parents_of(const DepthCells& fine, const DepthCells& coarse) {
  std::vector<int> parents(fine.count.size());
  int* parent = parents.data();
  for (int j = 0; j < fine.height; ++j) {
    const int first = (j / 2) * coarse.width;
    for (int i = 0; i < fine.width; ++i) *parent++ = first + i / 2;
  }
  return parents;
}

/// Bounds of the noise at any depth, since the noise itself takes a power. It grows with depth, so
/// it lies between those at the ends of an interval of depths.
class SigmaBounds {
 public:
  explicit SigmaBounds(const NoiseModel& noise) {
    for (std::uint32_t k = 0; k <= kIntervals; ++k) {
      at_.push_back(noise.sigma(std::bit_cast<float>((kFirst + k) << kShift)));
    }
  }
  /// The least and the most that the noise may be at depth z [m].
  std::pair<float, float> operator()(float z) const {
    const std::uint32_t k = (std::bit_cast<std::uint32_t>(z) >> kShift) - kFirst;
    if (k >= kIntervals) return {0.0f, std::numeric_limits<float>::infinity()};
    return {at_.data()[k] * (1.0f - kRounding), at_.data()[k + 1] * (1.0f + kRounding)};
  }

 private:
  // The upper bits of a number divide each power of two into 32 intervals of equal length.
  static constexpr int kShift = 18;
  // The intervals from 1/8 m to 8 m, where nearly all points are.
  static constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(0.125f) >> kShift;
  static constexpr std::uint32_t kIntervals =
      (std::bit_cast<std::uint32_t>(8.0f) >> kShift) - kFirst;
  // More than the error of a power.
  static constexpr float kRounding = 1e-5f;

  /// The noise at the beginnings of the intervals and at the end of the last [m].
  std::vector<float> at_;
};

class DepthPyramid : public CellPyramid {
 public:
  /// @param z  depth at which the levels' noise is compared [m]
  DepthPyramid(const PinholeView& view, std::array<DepthCells, kLevels> cells,
               std::vector<NoiseModel> noise, float z)
      : view_(view),
        X_CV_(view.X_VC.inverse()),
        cells_(std::move(cells)),
        noise_(std::move(noise)),
        sigma_bounds_(noise_.front()),
        common_noise_(common_share(noise_.front().sigma(z), noise_.back().sigma(z))) {
    for (int l = 0; l + 1 < kLevels; ++l) parents_[l] = parents_of(cells_[l], cells_[l + 1]);
  }

  int size(int level) const override { return cells_[level].size(); }
  const std::vector<int>& parents(int level) const override { return parents_[level]; }
  int count(int cell) const override { return cells_[0].count[cell]; }
  Eigen::Vector3f mean(int cell) const override { return X_CV_ * cells_[0].position_V(cell); }
  float sigma(int cell) const override { return noise_[0].sigma(1.0f / cells_[0].w[cell]); }
  std::pair<float, float> sigma_bounds(int cell) const override {
    return sigma_bounds_(1.0f / cells_[0].w[cell]);
  }
  int cell_of(const Eigen::Vector3f& point) const override {
    return cells_[0].cell_of(view_(point));
  }
  void visit_points(const CloudView& cloud, std::size_t step, std::span<const int> owner,
                    const VisitPoint& visit) const override {
    const DepthCells& cells = cells_[0];
    PinholeView view = view_;
    view.stride = static_cast<int>(step);
    for (std::size_t k = 0; k < view.looked_at(cloud.points.size()); k += SeenPoints::kSize) {
      const SeenPoints t = view.look(cloud.points, k);
      std::array<int, SeenPoints::kSize> found;
      cells.look_up(t, &found);
      for (std::size_t i = 0; i < found.size(); ++i) {
        const int c = found[i];
        if (c < 0 || owner[c] < 0 || !cells.holds(c, t.w[i])) continue;
        visit((k + i) * step, c);
      }
    }
  }

  Sight sight() const override {
    const DepthCells& cells = cells_[0];
    return {view_.X_VC,  cells.image.corner, cells.pitch() * static_cast<float>(cells.pixels),
            cells.width, cells.height,       cells.w};
  }

  const PinholeView* view() const override { return view_.stride == 1 ? &view_ : nullptr; }

  SurfaceSamples coarse_samples() const override {
    return make_depth_samples(cells_[kLevels - 1], {}, noise_[kLevels - 1], X_CV_, kPlaneReach);
  }

  std::vector<SurfaceSamples> samples(const Mask& keep, int threads) const override {
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
  SigmaBounds sigma_bounds_;
  double common_noise_;
  std::array<std::vector<int>, kLevels - 1> parents_;
};

/// Depth that three tenths of the points are nearer than, at which cells have their nominal size
/// [m]; 1 m if no point is seen.
float near_depth(const CloudView& cloud, const PinholeView& view) {
  std::vector<float> w;
  for (std::size_t i = 0; i < cloud.points.size(); i += step_over(view.seen)) {
    const float inverse_depth = view(cloud.points[i]).z();
    if (inverse_depth > 0.0f) w.push_back(inverse_depth);
  }
  if (w.empty()) return 1.0f;
  return 1.0f / nth_smallest(w, w.size() * 7 / 10);
}

/// Least edge of the cells [pixels], such that they are about max_cells at most.
double least_pixels(const PinholeView& view, const SamplingOptions& options) {
  const double pixels = static_cast<double>(view.seen) * options.stride * options.stride;
  return std::max(1.0, std::sqrt(pixels / options.max_cells));
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
  // A sensor that far away would not see the objects sought, so the viewpoint is not the sensor's.
  if (z > kFarthest) return nullptr;
  const int pixels = static_cast<int>(
      std::lround(std::clamp(options.cell / (image->pitch.x() * z), least_pixels(*view, options),
                             1.0 * std::max(image->width, image->height))));
  std::array<DepthCells, kLevels> cells;
  cells[0] = make_depth_cells(cloud, *view, *image, pixels);
  // Cells of one pixel hold too few points to tell layers.
  const double layered =
      pixels > 1 ? cells[0].layered : make_depth_cells(cloud, *view, *image, 2).layered;
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

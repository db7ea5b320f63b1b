#include "view/pixel_pitch.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace quadrille {

namespace {

constexpr double kMaxPixels = 4e6;
// No camera has finer pixels; steps below this are rounding, not a grid.
constexpr double kFinestPitch = 1e-5;

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Comb {
  double phase, concentration;
};

// How well values fall on a comb of that pitch: 1 means exactly, 0 evenly spread.
Comb comb(const std::vector<Eigen::Vector2d>& tangents, int axis, double pitch) {
  const std::size_t stride = std::max<std::size_t>(1, tangents.size() / 20000);
  std::complex<double> sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < tangents.size(); i += stride, ++count) {
    sum += std::polar(1.0, 2.0 * std::numbers::pi * tangents[i][axis] / pitch);
  }
  return {std::arg(sum) * pitch / (2.0 * std::numbers::pi), std::abs(sum) / count};
}

// Steps between neighbours of one row, and from one row to the next.
std::optional<PixelGrid> regular_grid(const std::vector<Eigen::Vector2d>& tangents,
                                      const Eigen::AlignedBox2d& bounds) {
  std::vector<double> along, across;
  const std::size_t stride = std::max<std::size_t>(1, tangents.size() / 20000);
  std::size_t next = stride;
  for (std::size_t i = 1; i < tangents.size(); ++i) {
    const Eigen::Vector2d step = tangents[i] - tangents[i - 1];
    const bool sampled = i == next;
    if (sampled) next += stride;
    if (sampled && step.x() > 5.0 * std::abs(step.y())) along.push_back(step.x());
    if (step.x() < -0.05 * bounds.sizes().x() && step.y() > 0.0) across.push_back(step.y());
  }
  if (along.size() < 100 || across.size() < 10) return std::nullopt;
  PixelGrid grid;
  grid.pitch = {median(along), median(across)};
  for (int axis = 0; axis < 2; ++axis) {
    const Comb found = comb(tangents, axis, grid.pitch[axis]);
    // Also refuses a pitch so small that the comb is not a number.
    if (!(found.concentration >= 0.8)) return std::nullopt;
    grid.phase[axis] = found.phase;
  }
  return grid;
}

// From the median count of points in coarse, occupied bins.
PixelGrid density_grid(const std::vector<Eigen::Vector2d>& tangents,
                       const Eigen::AlignedBox2d& bounds) {
  constexpr double kPointsPerPixel = 2.0;
  const int bins = std::clamp(static_cast<int>(std::sqrt(tangents.size() / 8.0)), 1, 48);
  const Eigen::Vector2d bin = bounds.sizes().cwiseMax(1e-6) / bins;
  std::vector<int> counts(bins * bins, 0);
  for (const Eigen::Vector2d& t : tangents) {
    const Eigen::Vector2i at =
        (t - bounds.min()).cwiseQuotient(bin).cast<int>().cwiseMax(0).cwiseMin(bins - 1);
    ++counts[at.y() * bins + at.x()];
  }
  std::vector<double> occupied;
  for (const int n : counts) {
    if (n > 0) occupied.push_back(n);
  }
  PixelGrid grid;
  grid.pitch.setConstant(std::sqrt(bin.prod() * kPointsPerPixel / median(occupied)));
  grid.phase = bounds.min();
  return grid;
}

double count_pixels(const PixelGrid& grid, const Eigen::AlignedBox2d& bounds) {
  return (bounds.sizes().cwiseQuotient(grid.pitch) + Eigen::Vector2d::Ones()).prod();
}

}  // namespace

PixelGrid find_pixel_grid(const std::vector<Eigen::Vector2d>& tangents,
                          const Eigen::AlignedBox2d& bounds) {
  const std::optional<PixelGrid> regular = regular_grid(tangents, bounds);
  PixelGrid grid = regular ? *regular : density_grid(tangents, bounds);
  const Eigen::Vector2d found = grid.pitch;
  grid.pitch = found.cwiseMax(kFinestPitch);
  // An axis that is down to one pixel shrinks no further, so that one step may not be enough.
  for (double excess = count_pixels(grid, bounds) / kMaxPixels; excess > 1.0;
       excess = count_pixels(grid, bounds) / kMaxPixels) {
    grid.pitch *= std::max(std::sqrt(excess), 1.01);
  }
  if (grid.pitch != found) grid.phase = bounds.min();
  return grid;
}

}  // namespace quadrille

#include "quadrille/detector/noise.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

constexpr float kLeastSigma = 1e-4f;
constexpr int kPatches = 600;
constexpr int kLargestReach = 12;

using Vector6f = Eigen::Matrix<float, 6, 1>;

/// Root mean square residual, in depth, of a quadratic patch around cell (i, j); negative if the
/// patch holds too few cells.
float patch_residual(const DepthCells& cells, int i, int j, int reach) {
  const int centre = j * cells.width + i;
  const float scale = 1.0f / (cells.view.pitch * static_cast<float>(cells.pixels * reach));
  Eigen::Matrix<float, 7, 7> moments = Eigen::Matrix<float, 7, 7>::Zero();
  int n = 0;
  for (int y = std::max(0, j - reach); y <= std::min(cells.height - 1, j + reach); ++y) {
    for (int x = std::max(0, i - reach); x <= std::min(cells.width - 1, i + reach); ++x) {
      const int c = y * cells.width + x;
      if ((x - i) * (x - i) + (y - j) * (y - j) > reach * reach || cells.count[c] == 0) continue;
      const float s = (cells.u[c] - cells.u[centre]) * scale;
      const float t = (cells.v[c] - cells.v[centre]) * scale;
      const float dw = cells.w[c] / cells.w[centre] - 1.0f;
      if (std::abs(dw) > 0.1f) return -1.0f;  // a depth edge runs through the patch
      Eigen::Matrix<float, 7, 1> row;
      row << 1, s, t, s * s, s * t, t * t, dw;
      moments.selfadjointView<Eigen::Lower>().rankUpdate(row);
      ++n;
    }
  }
  if (n < 2 * reach * reach || n < 14) return -1.0f;
  moments = Eigen::Matrix<float, 7, 7>(moments.selfadjointView<Eigen::Lower>());
  const Eigen::Matrix<double, 6, 6> M = moments.topLeftCorner<6, 6>().cast<double>();
  const Eigen::Matrix<double, 6, 1> b = moments.topRightCorner<6, 1>().cast<double>();
  const Eigen::Matrix<double, 6, 1> a = M.ldlt().solve(b);
  const double rss = std::max(0.0, static_cast<double>(moments(6, 6)) - a.dot(b));
  return static_cast<float>(std::sqrt(rss / (n - 6))) / cells.w[centre];
}

float quantile_of(std::vector<float>& values, double quantile) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(quantile * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

float NoiseModel::sigma(float z) const {
  return std::max(kLeastSigma, static_cast<float>(factor * std::pow(z, exponent)));
}

NoiseModel measure_noise(const DepthCells& cells, double radius, double quantile) {
  std::vector<std::pair<float, float>> depth_residual;
  const int stride =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(cells.size()) / kPatches)));
  for (int j = stride / 2; j < cells.height; j += stride) {
    for (int i = stride / 2; i < cells.width; i += stride) {
      const int c = j * cells.width + i;
      if (cells.count[c] == 0) continue;
      const int reach = std::clamp(
          static_cast<int>(std::lround(radius / cells.metric(cells.w[c]))), 3, kLargestReach);
      const float r = patch_residual(cells, i, j, reach);
      if (r >= 0) depth_residual.emplace_back(1.0f / cells.w[c], r);
    }
  }
  NoiseModel model;
  if (depth_residual.size() < 8) return model;
  std::sort(depth_residual.begin(), depth_residual.end());
  // Near and far half: two quantiles give the growth, held within what sensors show.
  const std::size_t half = depth_residual.size() / 2;
  float depth[2], residual[2];
  for (int k = 0; k < 2; ++k) {
    std::vector<float> r, z;
    for (std::size_t i = k ? half : 0; i < (k ? depth_residual.size() : half); ++i) {
      z.push_back(depth_residual[i].first);
      r.push_back(depth_residual[i].second);
    }
    depth[k] = quantile_of(z, 0.5);
    residual[k] = std::max(kLeastSigma, quantile_of(r, quantile));
  }
  if (depth[1] > 1.2f * depth[0]) {
    model.exponent = std::clamp(std::log(residual[1] / residual[0]) / std::log(depth[1] / depth[0]),
                                1.0f, 2.5f);
  }
  model.factor = std::sqrt(residual[0] / std::pow(depth[0], model.exponent) * residual[1] /
                           std::pow(depth[1], model.exponent));
  return model;
}

}  // namespace quadrille

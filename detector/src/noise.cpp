#include "quadrille/detector/noise.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

namespace quadrille {
namespace {

constexpr float kLeastSigma = 1e-4f;
constexpr int kLeastReach = 3, kLargestReach = 8;

/// w / w₀ − 1 as a quadratic in the offsets (s, t) from the centre, scaled to the patch.
struct Patch {
  float u0, v0, w0, scale;
  Eigen::Matrix<float, 6, 1> a;

  Eigen::Matrix<float, 6, 1> monomials(float u, float v) const {
    const float s = (u - u0) * scale, t = (v - v0) * scale;
    Eigen::Matrix<float, 6, 1> m;
    m << 1, s, t, s * s, s * t, t * t;
    return m;
  }
  float residual(float u, float v, float w) const { return w / w0 - 1.0f - a.dot(monomials(u, v)); }
};

/// Fits a patch around cell (i, j); nullopt if it is mostly empty or a depth edge runs through it.
std::optional<Patch> fit_patch(const DepthCells& cells, int i, int j, int reach) {
  const int centre = j * cells.width + i;
  Patch patch;
  patch.u0 = cells.u[centre], patch.v0 = cells.v[centre], patch.w0 = cells.w[centre];
  patch.scale = 1.0f / (cells.image.pitch * static_cast<float>(cells.pixels * reach));
  Eigen::Matrix<float, 6, 6> A = Eigen::Matrix<float, 6, 6>::Zero();
  Eigen::Matrix<float, 6, 1> b = Eigen::Matrix<float, 6, 1>::Zero();
  int n = 0;
  for (int y = std::max(0, j - reach); y <= std::min(cells.height - 1, j + reach); ++y) {
    int last = -1;
    for (int x = std::max(0, i - reach); x <= std::min(cells.width - 1, i + reach); ++x) {
      const int c = y * cells.width + x;
      if ((x - i) * (x - i) + (y - j) * (y - j) > reach * reach || cells.count[c] == 0) continue;
      if (last >= 0 && !continuous(cells, cells.w[c], cells.w[last])) return std::nullopt;
      last = c;
      const Eigen::Matrix<float, 6, 1> m = patch.monomials(cells.u[c], cells.v[c]);
      A.noalias() += m * m.transpose();
      b += (cells.w[c] / patch.w0 - 1.0f) * m;
      ++n;
    }
  }
  if (n < 2 * reach * reach) return std::nullopt;
  patch.a = A.cast<double>().ldlt().solve(b.cast<double>()).cast<float>();
  if (!patch.a.allFinite()) return std::nullopt;
  return patch;
}

/// Root mean square residual in depth of the level's cells over the patch; negative if none.
float patch_residual(const DepthCells& cells, const Patch& patch, double lost) {
  const float step = cells.image.pitch * static_cast<float>(cells.pixels);
  const int i = static_cast<int>((patch.u0 - cells.image.u0) / step);
  const int j = static_cast<int>((patch.v0 - cells.image.v0) / step);
  const int reach = std::max(1, static_cast<int>(1.0f / (patch.scale * step)));
  // Of a fine level's many cells every second one, both ways, tells as much.
  const int stride = reach > kLargestReach ? 2 : 1;
  double square = 0;
  int n = 0;
  for (int y = std::max(0, j - reach); y <= std::min(cells.height - 1, j + reach); y += stride) {
    for (int x = std::max(0, i - reach); x <= std::min(cells.width - 1, i + reach); x += stride) {
      const int c = y * cells.width + x;
      if ((x - i) * (x - i) + (y - j) * (y - j) > reach * reach || cells.count[c] == 0) continue;
      const float r = patch.residual(cells.u[c], cells.v[c], cells.w[c]);
      square += static_cast<double>(r) * r;
      ++n;
    }
  }
  if (n < 2 * lost + 4) return -1.0f;
  return static_cast<float>(std::sqrt(square / (n - lost))) / patch.w0;
}

float quantile_of(std::vector<float>& values, double quantile) {
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(quantile * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The quantile at the near and at the far half gives the growth, held within what sensors show.
NoiseModel fit_growth(std::vector<std::pair<float, float>> depth_residual, double quantile) {
  NoiseModel model;
  if (depth_residual.size() < 8) return model;
  std::sort(depth_residual.begin(), depth_residual.end());
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
    model.exponent =
        std::clamp(std::log(residual[1] / residual[0]) / std::log(depth[1] / depth[0]), 1.0f, 2.5f);
  }
  model.factor = std::sqrt(residual[0] / std::pow(depth[0], model.exponent) * residual[1] /
                           std::pow(depth[1], model.exponent));
  return model;
}

// What white noise leaves on the third level, with what little clutter adds to its quarter.
constexpr double kWhite = 0.35;

}  // namespace

double common_share(double finest_sigma, double coarsest_sigma) {
  const double ratio = std::clamp(coarsest_sigma / finest_sigma, kWhite, 1.0);
  return std::sqrt(ratio * ratio - kWhite * kWhite);
}

float NoiseModel::sigma(float z) const {
  return std::max(kLeastSigma,
                  static_cast<float>(factor * std::pow(z, static_cast<float>(exponent))));
}

std::vector<NoiseModel> measure_noise(std::span<const DepthCells> levels,
                                      const NoiseOptions& options) {
  const DepthCells& cells = levels[std::min<std::size_t>(1, levels.size() - 1)];
  std::vector<std::vector<std::pair<float, float>>> depth_residual(levels.size());
  const int stride =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(cells.size()) / options.patches)));
  for (int j = stride / 2; j < cells.height; j += stride) {
    for (int i = stride / 2; i < cells.width; i += stride) {
      const int c = j * cells.width + i;
      if (cells.count[c] == 0) continue;
      const int reach =
          std::clamp(static_cast<int>(std::lround(options.radius / cells.metric(cells.w[c]))),
                     kLeastReach, kLargestReach);
      const std::optional<Patch> patch = fit_patch(cells, i, j, reach);
      if (!patch) continue;
      for (std::size_t l = 0; l < levels.size(); ++l) {
        // The fit has taken its six parameters from the second level's cells; on coarser ones
        // that weighs more, on finer ones their own noise is hardly touched.
        const float r = patch_residual(levels[l], *patch, l == 0 ? 1.5 : 6.0);
        if (r >= 0) depth_residual[l].emplace_back(1.0f / patch->w0, r);
      }
    }
  }
  std::vector<NoiseModel> models;
  for (auto& list : depth_residual) models.push_back(fit_growth(std::move(list), options.quantile));
  return models;
}

}  // namespace quadrille

#include "samples/depth/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/quantile.hpp"
#include "base/vector_clones.hpp"
#include "samples/height_fit.hpp"

namespace quadrille {
namespace {

// Bounds of a patch's half width [cells]: smaller patches leave no residual, larger ones only take
// time.
constexpr int kMinReach = 3, kMaxReach = 8;
// Cells that the six parameters of a patch's fit use up, on the level on which it is fitted and on
// coarser ones. On the finer level, four cells take part in the fit as one.
constexpr double kLostCells = 6.0, kLostFineCells = kLostCells / 4.0;
// Bounds of the growth: the exponent 1 of time-of-flight sensors, and somewhat more than the
// exponent 2 of triangulating sensors.
constexpr float kMinExponent = 1.0f, kMaxExponent = 2.5f;
// Least ratio of the depths of the two halves at which a growth can be told from chance.
constexpr float kMinDepthRatio = 1.2f;
// Share of the finest level's white noise that remains on the coarsest level: a quarter, plus a
// margin for clutter.
constexpr double kWhiteShare = 0.35;

/// Number of depth edges in each row before each cell. If two cells of a row have the same number,
/// each filled cell between them continues the one before.
std::vector<int> count_edges(const DepthCells& cells) {
  std::vector<int> edges(static_cast<std::size_t>(cells.size()), 0);
  for (int j = 0; j < cells.height; ++j) {
    float last = 0;
    int n = 0;
    for (int c = j * cells.width; c < (j + 1) * cells.width; ++c) {
      if (cells.count[c] > 0) {
        n += last > 0 && !continuous(cells, cells.w[c], last);
        last = cells.w[c];
      }
      edges[c] = n;
    }
  }
  return edges;
}

/// A quadratic for w / w₀ − 1 in the offsets (s, t) from the centre, scaled to the patch.
struct Patch {
  float u0, v0, w0, scale;
  std::array<float, 6> a;
};

/// Some consecutive cells of a row, at most kLanes.
struct CellRun {
  const DepthCells& cells;
  int first, n;
};

/// Offsets and relative heights of consecutive cells over a patch; all 0 for empty cells.
struct Heights {
  std::array<float, kLanes> one, s, t, h;

  QUADRILLE_INTO_CLONES Heights(const CellRun& run, const Patch& patch) {
    const DepthCells& cells = run.cells;
    const float over = 1.0f / patch.w0;
    std::array<int, kLanes> count{};
    std::array<float, kLanes> u{}, v{}, w{};
    const auto read = [&](int n) {
      std::copy_n(cells.count.data() + run.first, n, count.data());
      std::copy_n(cells.u.data() + run.first, n, u.data());
      std::copy_n(cells.v.data() + run.first, n, v.data());
      std::copy_n(cells.w.data() + run.first, n, w.data());
    };
    // Vectors may read past the run, but not past the image.
    if (run.first + kLanes <= cells.size()) {
      read(kLanes);
    } else {
      read(run.n);
    }
    for (int k = 0; k < kLanes; ++k) {
      const int filled = static_cast<int>(k < run.n) & static_cast<int>(count[k] > 0);
      one[k] = static_cast<float>(filled);
      s[k] = one[k] * (u[k] - patch.u0) * patch.scale;
      t[k] = one[k] * (v[k] - patch.v0) * patch.scale;
      h[k] = one[k] * (w[k] * over - 1.0f);
    }
  }
};

/// Sums for the least-squares fit of a quadratic, in separate vector lanes: the monomials s^p t^q
/// up to degree four, and h times those up to degree two.
struct PatchSums {
  std::array<std::array<float, kLanes>, 15> moment{};
  std::array<std::array<float, kLanes>, 6> height{};

  HeightFit fit() const;
  int cells() const {
    return static_cast<int>(std::accumulate(moment[0].begin(), moment[0].end(), 0.0f));
  }
};

QUADRILLE_VECTOR_CLONES
void add(const CellRun& run, const Patch& patch, PatchSums* sums) {
  const Heights c(run, patch);
  auto& m = sums->moment;
  auto& b = sums->height;
  for (int k = 0; k < kLanes; ++k) {
    const float s = c.s[k], t = c.t[k], h = c.h[k], ss = s * s, st = s * t, tt = t * t;
    m[0][k] += c.one[k], m[1][k] += s, m[2][k] += t, m[3][k] += ss, m[4][k] += st, m[5][k] += tt;
    m[6][k] += ss * s, m[7][k] += ss * t, m[8][k] += s * tt, m[9][k] += tt * t;
    m[10][k] += ss * ss, m[11][k] += ss * st, m[12][k] += ss * tt, m[13][k] += st * tt;
    m[14][k] += tt * tt;
    b[0][k] += h, b[1][k] += h * s, b[2][k] += h * t;
    b[3][k] += h * ss, b[4][k] += h * st, b[5][k] += h * tt;
  }
}

HeightFit PatchSums::fit() const {
  // Index of the moment for each pair of the monomials 1, s, t, s², s t, t².
  constexpr int kMoment[6][6] = {{0, 1, 2, 3, 4, 5},    {1, 3, 4, 6, 7, 8},
                                 {2, 4, 5, 7, 8, 9},    {3, 6, 7, 10, 11, 12},
                                 {4, 7, 8, 11, 12, 13}, {5, 8, 9, 12, 13, 14}};
  const auto total = [](const std::array<float, kLanes>& lanes) {
    return std::accumulate(lanes.begin(), lanes.end(), 0.0);
  };
  HeightFit fit;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) fit.A(i, j) = total(moment[kMoment[i][j]]);
    fit.b[i] = total(height[i]);
  }
  return fit;
}

/// Sum of the squared residuals, and the number of cells.
struct Residuals {
  double square = 0;
  int n = 0;
};

QUADRILLE_VECTOR_CLONES
void add(const CellRun& run, const Patch& patch, Residuals* sums) {
  const Heights c(run, patch);
  float square = 0, n = 0;
  std::array<float, kLanes> r;
  for (int k = 0; k < kLanes; ++k) {
    const auto& a = patch.a;
    const float s = c.s[k], t = c.t[k];
    r[k] = c.h[k] - c.one[k] * (a[0] + s * (a[1] + a[3] * s + a[4] * t) + t * (a[2] + a[5] * t));
  }
  for (int k = 0; k < kLanes; ++k) square += r[k] * r[k], n += c.one[k];
  sums->square += static_cast<double>(square);
  sums->n += static_cast<int>(n);
}

/// Calls visit(first, n) for every stride-th row of a disc of cells around (i, j).
template <class Visitor>
void visit_disc(const DepthCells& cells, int i, int j, int reach, int stride, Visitor&& visit) {
  for (int y = std::max(0, j - reach); y <= std::min(cells.height - 1, j + reach); y += stride) {
    const int half =
        static_cast<int>(std::sqrt(static_cast<float>(reach * reach - (y - j) * (y - j))));
    const int from = std::max(0, i - half), to = std::min(cells.width - 1, i + half);
    if (from <= to) visit(y * cells.width + from, to - from + 1);
  }
}

/// Fits a patch around cell (i, j); nullopt if it is mostly empty or a depth edge runs through it.
std::optional<Patch> fit_patch(const DepthCells& cells, const std::vector<int>& edges, int i, int j,
                               int reach) {
  const int centre = j * cells.width + i;
  Patch patch{};
  patch.u0 = cells.u[centre], patch.v0 = cells.v[centre], patch.w0 = cells.w[centre];
  patch.scale = 1.0f / (cells.pitch() * static_cast<float>(cells.pixels * reach));
  PatchSums sums;
  bool torn = false;
  visit_disc(cells, i, j, reach, 1, [&](int first, int n) {
    const int end = first + n;
    int filled = first;
    while (filled < end && cells.count[filled] == 0) ++filled;
    if (filled == end) return;
    torn |= edges[end - 1] != edges[filled];
    for (int c = first; c < end; c += kLanes) {
      add({cells, c, std::min(kLanes, end - c)}, patch, &sums);
    }
  });
  if (torn || sums.cells() < 2 * reach * reach) return std::nullopt;
  const HeightFit fit = sums.fit();
  const HeightFit::Vector6 a = fit.factor().solve(fit.b);
  if (!a.allFinite()) return std::nullopt;
  for (int k = 0; k < 6; ++k) patch.a[k] = static_cast<float>(a[k]);
  return patch;
}

/// Root mean square residual in depth of the level's cells over the patch [m]; negative if they are
/// too few.
float patch_residual(const DepthCells& cells, const Patch& patch, double lost) {
  const float step = cells.pitch() * static_cast<float>(cells.pixels);
  const int i = static_cast<int>((patch.u0 - cells.image.corner.x()) / step);
  const int j = static_cast<int>((patch.v0 - cells.image.corner.y()) / step);
  const int reach = std::max(1, static_cast<int>(1.0f / (patch.scale * step)));
  // On a fine level with many cells, every second row suffices.
  const int stride = reach > kMaxReach ? 2 : 1;
  Residuals sums;
  visit_disc(cells, i, j, reach, stride, [&](int first, int n) {
    for (int k = 0; k < n; k += kLanes) {
      add({cells, first + k, std::min(kLanes, n - k)}, patch, &sums);
    }
  });
  if (sums.n < 2 * lost + 4) return -1.0f;
  return static_cast<float>(std::sqrt(sums.square / (sums.n - lost))) / patch.w0;
}

/// Determines the growth from the quantiles of the residuals in the near and in the far half,
/// within the limits known from sensors.
NoiseModel fit_growth(std::vector<std::pair<float, float>> depth_residual, double share) {
  NoiseModel model;
  if (depth_residual.size() < kMinResiduals) return model;
  std::sort(depth_residual.begin(), depth_residual.end());
  const std::size_t half = depth_residual.size() / 2;
  float depth[2], residual[2];
  for (int k = 0; k < 2; ++k) {
    std::vector<float> r, z;
    for (std::size_t i = k ? half : 0; i < (k ? depth_residual.size() : half); ++i) {
      z.push_back(depth_residual[i].first);
      r.push_back(depth_residual[i].second);
    }
    depth[k] = quantile(z, 0.5);
    residual[k] = std::max(kMinSigma, quantile(r, share));
  }
  if (depth[1] > kMinDepthRatio * depth[0]) {
    model.exponent = std::clamp(std::log(residual[1] / residual[0]) / std::log(depth[1] / depth[0]),
                                kMinExponent, kMaxExponent);
  }
  model.factor = std::sqrt(residual[0] / std::pow(depth[0], model.exponent) * residual[1] /
                           std::pow(depth[1], model.exponent));
  return model;
}

}  // namespace

double common_share(double finest_sigma, double coarsest_sigma) {
  const double ratio = std::clamp(coarsest_sigma / finest_sigma, kWhiteShare, 1.0);
  return std::sqrt(ratio * ratio - kWhiteShare * kWhiteShare);
}

float NoiseModel::sigma(float z) const {
  return std::max(kMinSigma,
                  static_cast<float>(factor * std::pow(z, static_cast<float>(exponent))));
}

std::vector<NoiseModel> measure_noise(std::span<const DepthCells> levels,
                                      const NoiseOptions& options) {
  const DepthCells& cells = levels[std::min<std::size_t>(1, levels.size() - 1)];
  const std::vector<int> edges = count_edges(cells);
  std::vector<std::vector<std::pair<float, float>>> depth_residual(levels.size());
  const int stride =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(cells.size()) / options.patches)));
  for (int j = stride / 2; j < cells.height; j += stride) {
    for (int i = stride / 2; i < cells.width; i += stride) {
      const int c = j * cells.width + i;
      if (cells.count[c] == 0) continue;
      const int reach =
          std::clamp(static_cast<int>(std::lround(options.radius / cells.metric(cells.w[c]))),
                     kMinReach, kMaxReach);
      const std::optional<Patch> patch = fit_patch(cells, edges, i, j, reach);
      if (!patch) continue;
      for (std::size_t l = 0; l < levels.size(); ++l) {
        const float r = patch_residual(levels[l], *patch, l == 0 ? kLostFineCells : kLostCells);
        if (r >= 0) depth_residual[l].emplace_back(1.0f / patch->w0, r);
      }
    }
  }
  std::vector<NoiseModel> models;
  models.reserve(depth_residual.size());
  for (auto& list : depth_residual) models.push_back(fit_growth(std::move(list), options.quantile));
  return models;
}

}  // namespace quadrille

#include "samples/depth/depth_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

/// Sums over a window for the affine fit of w, centred on the middle cell.
struct WindowSums {
  float n = 0, s = 0, t = 0, ss = 0, st = 0, tt = 0, w = 0, sw = 0, tw = 0;
};

// Cells that a fit needs: one more than it has parameters.
constexpr float kMinCells = 4.0f;
// Least determinant of the cells' scatter in a window, relative to that of a round scatter of the
// same trace. Below it the cells lie nearly on a line.
constexpr float kMinRoundness = 0.05f;

/// Inverse depth as an affine function of the offsets from the middle cell: a + b s + c t.
struct AffineFit {
  float a, b, c;
};

/// Solves the affine fit; nullopt if the window's cells are too few or nearly on a line.
std::optional<AffineFit> solve(const WindowSums& m) {
  if (m.n < kMinCells) return std::nullopt;
  const float s = m.s / m.n, t = m.t / m.n, w = m.w / m.n;
  const float ss = m.ss - m.n * s * s, st = m.st - m.n * s * t, tt = m.tt - m.n * t * t;
  const float sw = m.sw - m.n * s * w, tw = m.tw - m.n * t * w;
  const float det = ss * tt - st * st;
  if (det < kMinRoundness * (ss + tt) * (ss + tt) * 0.25f) return std::nullopt;
  AffineFit fit{};
  fit.b = (tt * sw - st * tw) / det;
  fit.c = (ss * tw - st * sw) / det;
  fit.a = w - fit.b * s - fit.c * t;
  return fit;
}

/// A copy of the usable cells with a border of empty ones, so that a window never ends at the edge
/// of the image and vectors may read past the end of a row.
struct BorderedCells {
  int stride;
  /// 1 for usable cells, otherwise 0.
  std::vector<float> usable;
  std::vector<float> u, v, w;

  BorderedCells(const DepthCells& cells, const Mask& use, int reach)
      : stride(cells.width + 2 * reach + kLanes) {
    const std::size_t size = static_cast<std::size_t>(stride) * (cells.height + 2 * reach + 1);
    usable.assign(size, 0.0f), u = usable, v = usable, w = usable;
    for (int j = 0; j < cells.height; ++j) {
      const std::ptrdiff_t from = std::ptrdiff_t{j} * cells.width;
      const std::ptrdiff_t to = std::ptrdiff_t{j + reach} * stride + reach;
      std::copy_n(use.begin() + from, cells.width, usable.begin() + to);
      std::copy_n(cells.u.begin() + from, cells.width, u.begin() + to);
      std::copy_n(cells.v.begin() + from, cells.width, v.begin() + to);
      std::copy_n(cells.w.begin() + from, cells.width, w.begin() + to);
    }
  }
};

using Lanes = std::array<float, kLanes>;

/// Sums over the windows of consecutive cells, each in a vector lane of its own.
struct WindowLanes {
  Lanes n{}, s{}, t{}, ss{}, st{}, tt{}, w{}, sw{}, tw{};

  WindowSums operator[](int k) const {
    return {n[k], s[k], t[k], ss[k], st[k], tt[k], w[k], sw[k], tw[k]};
  }
};

/// Sums over the cells around each of kLanes consecutive cells that may belong to its surface.
/// @param first  place of the first of them in the bordered cells
/// @param limit  largest step in depth of each
QUADRILLE_VECTOR_CLONES
void sum_windows(const BorderedCells& cells, int first, int reach, const Lanes& limit,
                 WindowLanes* sums) {
  WindowLanes m;
  const float *const u0 = &cells.u[first], *const v0 = &cells.v[first], *const w0 = &cells.w[first];
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const int at = first + y * cells.stride + x;
      const float *const u = &cells.u[at], *const v = &cells.v[at], *const w = &cells.w[at];
      const float* const usable = &cells.usable[at];
      for (int k = 0; k < kLanes; ++k) {
        const float du = u[k] - u0[k], dv = v[k] - v0[k], dw = w[k] - w0[k];
        const float one = std::abs(dw) > limit[k] * w[k] * w0[k] ? 0.0f : usable[k];
        const float s = one * du, t = one * dv, h = one * dw;
        m.n[k] += one;
        m.s[k] += s, m.t[k] += t, m.ss[k] += s * s, m.st[k] += s * t, m.tt[k] += t * t;
        m.w[k] += h, m.sw[k] += s * h, m.tw[k] += t * h;
      }
    }
  }
  *sums = m;
}

void add_sample(const DepthCells& cells, int c, const AffineFit& fit, const NoiseModel& noise,
                const Eigen::Isometry3f& X_CV, SurfaceSamples* samples) {
  const float u0 = cells.u[c], v0 = cells.v[c], w0 = cells.w[c];
  // On the plane n·x = d the inverse depth is 1/z = (n_x u + n_y v + n_z) / d.
  const float w = w0 + fit.a;
  Eigen::Vector3f n(fit.b, fit.c, w - fit.b * u0 - fit.c * v0);
  n.normalize();
  const Eigen::Vector3f ray(u0, v0, 1.0f);
  if (n.dot(ray) > 0) n = -n;
  samples->p.push_back(X_CV * Eigen::Vector3f(ray / w));
  samples->n.push_back(X_CV.linear() * n);
  samples->raw.push_back(X_CV * cells.position_V(c));
  samples->sigma.push_back(noise.sigma(1.0f / w0));
  samples->cell.push_back(cells.metric(w0));
  samples->count.push_back(cells.count[c]);
  samples->source.push_back(c);
}

/// Links the samples of neighbouring cells whose depths continue each other.
/// @param sample_of  per cell, its sample; -1 for none
void join_neighbours(const DepthCells& cells, const std::vector<int>& sample_of,
                     SurfaceSamples* samples) {
  const int width = cells.width, height = cells.height;
  samples->first.reserve(samples->p.size() + 1);
  samples->first.push_back(0);
  for (int k = 0; k < samples->size(); ++k) {
    const int c = samples->source[k], i = c % width, j = c / width;
    for (int y = std::max(0, j - 1); y <= std::min(height - 1, j + 1); ++y) {
      for (int x = std::max(0, i - 1); x <= std::min(width - 1, i + 1); ++x) {
        const int other = y * width + x;
        if (other == c || sample_of[other] < 0) continue;
        if (continuous(cells, cells.w[c], cells.w[other])) {
          samples->neighbours.push_back(sample_of[other]);
        }
      }
    }
    samples->first.push_back(static_cast<int>(samples->neighbours.size()));
  }
}

}  // namespace

SurfaceSamples make_depth_samples(const DepthCells& cells, const Mask& keep,
                                  const NoiseModel& noise, const Eigen::Isometry3f& X_CV,
                                  int reach) {
  Mask usable(static_cast<std::size_t>(cells.size()));
  for (int c = 0; c < cells.size(); ++c) {
    usable[c] = cells.count[c] > 0 && (keep.empty() || keep[c]);
  }
  SurfaceSamples samples;
  std::vector<int> sample_of(usable.size(), -1);
  const BorderedCells bordered(cells, usable, reach);
  WindowLanes sums;
  Lanes limit;
  for (int j = 0; j < cells.height; ++j) {
    for (int first = 0; first < cells.width; first += kLanes) {
      const int n = std::min(kLanes, cells.width - first), c0 = j * cells.width + first;
      if (std::none_of(&usable[c0], &usable[c0] + n, [](char use) { return use != 0; })) continue;
      for (int k = 0; k < n; ++k) {
        limit[k] = continuous_step(cells, cells.w[c0 + k]) * static_cast<float>(reach);
      }
      sum_windows(bordered, (j + reach) * bordered.stride + reach + first, reach, limit, &sums);
      for (int c = c0; c < c0 + n; ++c) {
        const std::optional<AffineFit> fit =
            usable[c] ? solve(sums[c - c0]) : std::optional<AffineFit>();
        if (!fit) continue;
        sample_of[c] = samples.size();
        add_sample(cells, c, *fit, noise, X_CV, &samples);
      }
    }
  }
  join_neighbours(cells, sample_of, &samples);
  return samples;
}

}  // namespace quadrille

#include "samples/depth/depth_samples.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Sums over the cells around (i, j) that may belong to its surface.
/// @param usable  filled cells to use
WindowSums sum_window(const DepthCells& cells, const Mask& usable, int i, int j, int reach) {
  const int c = j * cells.width + i;
  const float u0 = cells.u[c], v0 = cells.v[c], w0 = cells.w[c], z0 = 1.0f / w0;
  const float limit = continuous_step(cells, w0) * static_cast<float>(reach);
  WindowSums m;
  for (int y = std::max(0, j - reach); y <= std::min(cells.height - 1, j + reach); ++y) {
    for (int x = std::max(0, i - reach); x <= std::min(cells.width - 1, i + reach); ++x) {
      const int k = y * cells.width + x;
      if (!usable[k]) continue;
      const float dw = cells.w[k] - w0;
      if (std::abs(dw) * z0 > limit * cells.w[k]) continue;
      const float s = cells.u[k] - u0, t = cells.v[k] - v0;
      m.n += 1, m.s += s, m.t += t, m.ss += s * s, m.st += s * t, m.tt += t * t;
      m.w += dw, m.sw += s * dw, m.tw += t * dw;
    }
  }
  return m;
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
  for (int j = 0; j < cells.height; ++j) {
    for (int i = 0; i < cells.width; ++i) {
      const int c = j * cells.width + i;
      if (!usable[c]) continue;
      const std::optional<AffineFit> fit = solve(sum_window(cells, usable, i, j, reach));
      if (!fit) continue;
      sample_of[c] = samples.size();
      add_sample(cells, c, *fit, noise, X_CV, &samples);
    }
  }
  join_neighbours(cells, sample_of, &samples);
  return samples;
}

}  // namespace quadrille

#include "samples/depth/depth_samples.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>

namespace quadrille {
namespace {

/// Sums over a window for the affine fit of w, centred on the middle cell.
struct WindowSums {
  float n = 0, s = 0, t = 0, ss = 0, st = 0, tt = 0, w = 0, sw = 0, tw = 0;
};

/// Affine fit w = a + b s + c t; false if the window holds no triangle.
bool solve(const WindowSums& m, float* a, float* b, float* c) {
  if (m.n < 4) return false;
  const float s = m.s / m.n, t = m.t / m.n, w = m.w / m.n;
  const float ss = m.ss - m.n * s * s, st = m.st - m.n * s * t, tt = m.tt - m.n * t * t;
  const float sw = m.sw - m.n * s * w, tw = m.tw - m.n * t * w;
  const float det = ss * tt - st * st;
  if (det < 0.05f * (ss + tt) * (ss + tt) * 0.25f) return false;
  *b = (tt * sw - st * tw) / det;
  *c = (ss * tw - st * sw) / det;
  *a = w - *b * s - *c * t;
  return true;
}

}  // namespace

SurfaceSamples make_depth_samples(const DepthCells& cells, const std::vector<char>& keep,
                                  const NoiseModel& noise, const Eigen::Isometry3f& X_CV,
                                  int reach) {
  const int width = cells.width, height = cells.height;
  const auto usable = [&](int c) { return cells.count[c] > 0 && (keep.empty() || keep[c]); };

  SurfaceSamples samples;
  std::vector<int> sample_of(static_cast<std::size_t>(cells.size()), -1);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const int c = j * width + i;
      if (!usable(c)) continue;
      const float u0 = cells.u[c], v0 = cells.v[c], w0 = cells.w[c];
      const float z0 = 1.0f / w0;
      const float limit = continuous_step(cells, w0) * static_cast<float>(reach);
      WindowSums m;
      for (int y = std::max(0, j - reach); y <= std::min(height - 1, j + reach); ++y) {
        const int row = y * width;
        for (int x = std::max(0, i - reach); x <= std::min(width - 1, i + reach); ++x) {
          const int k = row + x;
          if (!usable(k)) continue;
          const float dw = cells.w[k] - w0;
          if (std::abs(dw) * z0 > limit * cells.w[k]) continue;
          const float s = cells.u[k] - u0, t = cells.v[k] - v0;
          m.n += 1, m.s += s, m.t += t, m.ss += s * s, m.st += s * t, m.tt += t * t;
          m.w += dw, m.sw += s * dw, m.tw += t * dw;
        }
      }
      float a, b, cc;
      if (!solve(m, &a, &b, &cc)) continue;
      // On the plane n·x = d: 1/z = (n_x u + n_y v + n_z) / d.
      const float w = w0 + a;
      Eigen::Vector3f n(b, cc, w - b * u0 - cc * v0);
      n.normalize();
      const Eigen::Vector3f ray(u0, v0, 1.0f);
      if (n.dot(ray) > 0) n = -n;
      sample_of[c] = samples.size();
      samples.p.push_back(X_CV * Eigen::Vector3f(ray / w));
      samples.n.push_back(X_CV.linear() * n);
      samples.raw.push_back(X_CV * cells.position_V(c));
      samples.sigma.push_back(noise.sigma(z0));
      samples.cell.push_back(cells.metric(w0));
      samples.count.push_back(cells.count[c]);
      samples.source.push_back(c);
    }
  }

  samples.first.reserve(samples.p.size() + 1);
  samples.first.push_back(0);
  for (int k = 0; k < samples.size(); ++k) {
    const int c = samples.source[k], i = c % width, j = c / width;
    for (int y = std::max(0, j - 1); y <= std::min(height - 1, j + 1); ++y) {
      for (int x = std::max(0, i - 1); x <= std::min(width - 1, i + 1); ++x) {
        const int other = y * width + x;
        if (other == c || sample_of[other] < 0) continue;
        if (continuous(cells, cells.w[c], cells.w[other])) {
          samples.neighbours.push_back(sample_of[other]);
        }
      }
    }
    samples.first.push_back(static_cast<int>(samples.neighbours.size()));
  }
  return samples;
}

}  // namespace quadrille

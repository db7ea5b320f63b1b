#include "samples/depth/depth_samples.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

// Cells that a fit needs: one more than it has parameters.
constexpr float kMinCells = 4.0f;
// Least determinant of the cells' scatter in a window, relative to that of a round scatter of the
// same trace. Below it the cells lie nearly on a line.
constexpr float kMinRoundness = 0.05f;

using Lanes = std::array<float, kLanes>;

/// Some consecutive cells, the first at these places in memory, with others around them.
struct CellWindow {
  /// 1 for usable cells, otherwise 0.
  const float* usable;
  const float *u, *v, *w;
  /// Number of places from a cell to that below it.
  int stride;
};

/// @param keep  cells to use; null for all
QUADRILLE_VECTOR_CLONES
void mark_usable(const int* __restrict count, const char* __restrict keep, int n,
                 float* __restrict usable) {
  for (int i = 0; i < n; ++i) usable[i] = static_cast<float>(static_cast<int>(count[i] > 0));
  if (!keep) return;
  for (int i = 0; i < n; ++i) usable[i] *= static_cast<float>(static_cast<int>(keep[i] != 0));
}

/// A copy of the cells with a border of empty ones, so that a window never ends at the edge of the
/// image and vectors may read past the end of a row.
class BorderedCells {
 public:
  BorderedCells(const DepthCells& cells, const Mask& keep, int reach)
      : reach_(reach), stride_(cells.width + 2 * reach + kLanes) {
    const std::size_t size = static_cast<std::size_t>(stride_) * (cells.height + 2 * reach + 1);
    usable_.assign(size, 0.0f), u_ = usable_, v_ = usable_, w_ = usable_;
    for (int j = 0; j < cells.height; ++j) {
      const std::ptrdiff_t from = std::ptrdiff_t{j} * cells.width;
      const std::ptrdiff_t to = std::ptrdiff_t{j + reach} * stride_ + reach;
      mark_usable(cells.count.data() + from, keep.empty() ? nullptr : keep.data() + from,
                  cells.width, usable_.data() + to);
      std::copy_n(cells.u.data() + from, cells.width, u_.data() + to);
      std::copy_n(cells.v.data() + from, cells.width, v_.data() + to);
      std::copy_n(cells.w.data() + from, cells.width, w_.data() + to);
    }
  }

  CellWindow at(int i, int j) const {
    const std::ptrdiff_t k = std::ptrdiff_t{j + reach_} * stride_ + reach_ + i;
    return {usable_.data() + k, u_.data() + k, v_.data() + k, w_.data() + k, stride_};
  }
  std::ptrdiff_t count_usable() const { return std::count(usable_.begin(), usable_.end(), 1.0f); }

 private:
  int reach_, stride_;
  std::vector<float> usable_, u_, v_, w_;
};

/// Sums over the windows of consecutive cells for the affine fit of w, centred on each cell, which
/// has a vector lane of its own.
struct WindowLanes {
  Lanes n{}, s{}, t{}, ss{}, st{}, tt{}, w{}, sw{}, tw{};
};

/// Sums over the cells around each of kLanes consecutive cells that may belong to its surface.
/// @param edge  of a cell, as a tangent
/// @return false if none of the cells is usable
QUADRILLE_VECTOR_CLONES
bool sum_windows(CellWindow cells, int reach, float edge, WindowLanes* sums) {
  float any = 0.0f;
  for (int k = 0; k < kLanes; ++k) any += cells.usable[k];
  if (any == 0.0f) return false;
  // The largest step in depth to a cell of the same surface.
  Lanes limit;
  for (int k = 0; k < kLanes; ++k) {
    limit[k] = continuous_step(edge, cells.w[k]) * static_cast<float>(reach);
  }
  WindowLanes m;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const std::ptrdiff_t at = std::ptrdiff_t{y} * cells.stride + x;
      const float *const u = cells.u + at, *const v = cells.v + at, *const w = cells.w + at;
      const float* const usable = cells.usable + at;
      QUADRILLE_KEEP_LOOP
      for (int k = 0; k < kLanes; ++k) {
        const float w0 = cells.w[k], du = u[k] - cells.u[k], dv = v[k] - cells.v[k], dw = w[k] - w0;
        const float one = std::abs(dw) > limit[k] * w[k] * w0 ? 0.0f : usable[k];
        const float s = one * du, t = one * dv, h = one * dw;
        m.n[k] += one;
        m.s[k] += s, m.t[k] += t, m.ss[k] += s * s, m.st[k] += s * t, m.tt[k] += t * t;
        m.w[k] += h, m.sw[k] += s * h, m.tw[k] += t * h;
      }
    }
  }
  *sums = m;
  return true;
}

/// For each of kLanes consecutive cells, bit i is set if the depth of its i-th neighbour, row by
/// row, continues its own.
using Links = std::array<int, kLanes>;

QUADRILLE_VECTOR_CLONES
void find_links(CellWindow cells, float edge, Links* links) {
  Links found{};
  int bit = 1;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && y == 0) continue;
      const float* const w = cells.w + std::ptrdiff_t{y} * cells.stride + x;
      QUADRILLE_KEEP_LOOP
      for (int k = 0; k < kLanes; ++k) {
        found[k] |= static_cast<int>(continuous(edge, cells.w[k], w[k])) * bit;
      }
      bit *= 2;
    }
  }
  *links = found;
}

/// The samples of consecutive cells.
struct SampleLanes {
  /// Nonzero if the cell has a sample.
  std::array<int, kLanes> valid;
  /// Coordinates of the fields of SurfaceSamples of the same names.
  std::array<Lanes, 3> p, n, raw;
  Lanes cell;
};

/// Fits inverse depth as an affine function a + b s + c t of the offsets from each cell's mean,
/// which gives a position and a normal. A window's cells must be enough and not nearly on a line.
QUADRILLE_VECTOR_CLONES
void fit_lanes(CellWindow cells, const WindowLanes& m, float edge, const Eigen::Matrix4f& X_CV,
               SampleLanes* samples) {
  SampleLanes out;
  // Nothing that is written may point to a copy, which lets the compiler make vectors.
  const Eigen::Matrix4f X = X_CV;  // NOLINT(performance-unnecessary-copy-initialization)
  for (int k = 0; k < kLanes; ++k) {
    const float s = m.s[k] / m.n[k], t = m.t[k] / m.n[k], w = m.w[k] / m.n[k];
    const float ss = m.ss[k] - m.n[k] * s * s, st = m.st[k] - m.n[k] * s * t;
    const float tt = m.tt[k] - m.n[k] * t * t;
    const float sw = m.sw[k] - m.n[k] * s * w, tw = m.tw[k] - m.n[k] * t * w;
    const float det = ss * tt - st * st;
    const float b = (tt * sw - st * tw) / det, c = (ss * tw - st * sw) / det;
    const float a = w - b * s - c * t;
    const int round = !(det < kMinRoundness * (ss + tt) * (ss + tt) * 0.25f);
    const int enough = m.n[k] >= kMinCells, use = cells.usable[k] > 0.0f;
    out.valid[k] = round & enough & use;

    // On the plane n·x = d the inverse depth is 1/z = (n_x u + n_y v + n_z) / d.
    const float u0 = cells.u[k], v0 = cells.v[k], w0 = cells.w[k], smooth_w = w0 + a;
    const float nz = smooth_w - b * u0 - c * v0;
    const float length = std::sqrt(b * b + (c * c + nz * nz));
    const int away = b * u0 + (c * v0 + nz) > 0.0f;
    const float sign = static_cast<float>(1 - 2 * away);
    const float n0 = sign * (b / length), n1 = sign * (c / length), n2 = sign * (nz / length);
    const float p0 = u0 / smooth_w, p1 = v0 / smooth_w, p2 = 1.0f / smooth_w;
    const float raw0 = u0 / w0, raw1 = v0 / w0, raw2 = 1.0f / w0;
    for (int i = 0; i < 3; ++i) {
      out.p[i][k] = X(i, 0) * p0 + X(i, 1) * p1 + X(i, 2) * p2 + X(i, 3);
      out.raw[i][k] = X(i, 0) * raw0 + X(i, 1) * raw1 + X(i, 2) * raw2 + X(i, 3);
      out.n[i][k] = X(i, 0) * n0 + (X(i, 1) * n1 + X(i, 2) * n2);
    }
    out.cell[k] = edge / w0;
  }
  *samples = out;
}

/// Sets the number of samples; new ones are yet to be filled in.
void resize(int count, SurfaceSamples* samples) {
  const auto size = static_cast<std::size_t>(count);
  samples->p.resize(size), samples->n.resize(size), samples->raw.resize(size);
  samples->sigma.resize(size), samples->cell.resize(size);
  samples->count.resize(size), samples->source.resize(size);
}

/// Places of the samples in memory. Most time is spent on writing them, so indices are not checked.
struct SamplePointers {
  Eigen::Vector3f *p, *n, *raw;
  float *sigma, *cell;
  int *count, *source;

  explicit SamplePointers(SurfaceSamples* s)
      : p(s->p.data()),
        n(s->n.data()),
        raw(s->raw.data()),
        sigma(s->sigma.data()),
        cell(s->cell.data()),
        count(s->count.data()),
        source(s->source.data()) {}

  /// Sets what lane k of some fits says of sample i.
  void set(int i, const SampleLanes& lanes, int k) const {
    const auto element = [k](const std::array<Lanes, 3>& xyz) {
      return Eigen::Vector3f(xyz[0].data()[k], xyz[1].data()[k], xyz[2].data()[k]);
    };
    p[i] = element(lanes.p), n[i] = element(lanes.n), raw[i] = element(lanes.raw);
    cell[i] = lanes.cell.data()[k];
  }
};

/// Links the samples of neighbouring cells whose depths continue each other.
/// @param sample_of  per cell, its sample; -1 for none
/// @param links      per sample, the linked neighbours of its cell
void join_neighbours(const DepthCells& cells, const std::vector<int>& sample_of,
                     const std::vector<std::uint8_t>& links, SurfaceSamples* samples) {
  const int width = cells.width;
  const std::array<int, 8> offsets = {-width - 1, -width,    -width + 1, -1,
                                      1,          width - 1, width,      width + 1};
  const int* const offset = offsets.data();
  const std::size_t size = samples->p.size();
  samples->first.resize(size + 1);
  samples->neighbours.resize(size * offsets.size());
  int* const first = samples->first.data();
  int* const begin = samples->neighbours.data();
  int* next = begin;
  for (std::size_t k = 0; k < size; ++k) {
    first[k] = static_cast<int>(next - begin);
    const int* const sample = sample_of.data() + samples->source.data()[k];
    for (unsigned list = links.data()[k]; list != 0; list &= list - 1) {
      const int other = sample[offset[std::countr_zero(list)]];
      *next = other;
      next += static_cast<int>(other >= 0);
    }
  }
  first[size] = static_cast<int>(next - begin);
  samples->neighbours.resize(static_cast<std::size_t>(next - begin));
}

}  // namespace

SurfaceSamples make_depth_samples(const DepthCells& cells, const Mask& keep,
                                  const NoiseModel& noise, const Eigen::Isometry3f& X_CV,
                                  int reach) {
  const float edge = cells.tangent();
  const BorderedCells bordered(cells, keep, reach);
  const int usable = static_cast<int>(bordered.count_usable());
  SurfaceSamples samples;
  resize(usable, &samples);
  const SamplePointers sample(&samples);
  std::vector<int> sample_of(static_cast<std::size_t>(cells.size()), -1);
  std::vector<std::uint8_t> links(static_cast<std::size_t>(usable));
  int next = 0;
  WindowLanes sums;
  SampleLanes lanes;
  Links linked;
  for (int j = 0; j < cells.height; ++j) {
    for (int first = 0; first < cells.width; first += kLanes) {
      const CellWindow window = bordered.at(first, j);
      if (!sum_windows(window, reach, edge, &sums)) continue;
      fit_lanes(window, sums, edge, X_CV.matrix(), &lanes);
      find_links(window, edge, &linked);
      const int n = std::min(kLanes, cells.width - first);
      for (int k = 0; k < n; ++k) {
        if (!lanes.valid.data()[k]) continue;
        const int c = j * cells.width + first + k, i = next++;
        sample_of.data()[c] = i;
        sample.set(i, lanes, k);
        sample.sigma[i] = noise.sigma(1.0f / window.w[k]);
        sample.count[i] = cells.count.data()[c];
        sample.source[i] = c;
        links.data()[i] = static_cast<std::uint8_t>(linked.data()[k]);
      }
    }
  }
  resize(next, &samples);
  join_neighbours(cells, sample_of, links, &samples);
  return samples;
}

}  // namespace quadrille

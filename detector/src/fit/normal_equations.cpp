#include "fit/normal_equations.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

// Where the gradient is weaker than this share of its mean, the first-order distance is cut: near
// an apex or a centre it would explode.
constexpr float kWeakGradient = 0.05f;
// Points are taken in chunks of this many, which compilers turn into vector instructions and which
// stay in the nearest cache. Sums run in kLanes strands, whatever the width of the vectors.
constexpr int kChunk = 128, kLanes = 8;
constexpr int kColumns = 11;

/// q in single precision: f = xᵀQx with x = (x y z 1).
struct Coefficients {
  float xx, yy, zz, xy, xz, yz, x, y, z, one;
  explicit Coefficients(const Eigen::Matrix4d& Q)
      : xx(static_cast<float>(Q(0, 0))),
        yy(static_cast<float>(Q(1, 1))),
        zz(static_cast<float>(Q(2, 2))),
        xy(static_cast<float>(Q(0, 1))),
        xz(static_cast<float>(Q(0, 2))),
        yz(static_cast<float>(Q(1, 2))),
        x(static_cast<float>(Q(0, 3))),
        y(static_cast<float>(Q(1, 3))),
        z(static_cast<float>(Q(2, 3))),
        one(static_cast<float>(Q(3, 3))) {}
};

/// A chunk of points; what is beyond the last one is zero.
struct alignas(32) Chunk {
  float x[kChunk], y[kChunk], z[kChunk];
  /// Half gradients, their length, and f.
  float gx[kChunk], gy[kChunk], gz[kChunk], slope[kChunk], f[kChunk];
  int size = 0;

  void load(const FitPoints& p, int first) {
    size = std::min(kChunk, static_cast<int>(p.size()) - first);
    const auto copy = [&](const Eigen::ArrayXf& from, float* to) {
      std::copy_n(from.data() + first, size, to);
      std::fill(to + size, to + kChunk, 0.0f);
    };
    copy(p.x, x), copy(p.y, y), copy(p.z, z);
  }
};

/// Eight sums side by side: one AVX register, or two SSE ones.
using Strands __attribute__((vector_size(kLanes * sizeof(float)), may_alias)) = float;

struct alignas(32) Jacobian {
  float column[kColumns][kChunk];
};

QUADRILLE_VECTOR_CLONES
void evaluate(Coefficients q, Chunk* c) {
  for (int k = 0; k < kChunk; ++k) {
    const float x = c->x[k], y = c->y[k], z = c->z[k];
    const float gx = q.xx * x + q.xy * y + q.xz * z + q.x;
    const float gy = q.xy * x + q.yy * y + q.yz * z + q.y;
    const float gz = q.xz * x + q.yz * y + q.zz * z + q.z;
    c->gx[k] = gx, c->gy[k] = gy, c->gz[k] = gz;
    c->f[k] = gx * x + gy * y + gz * z + q.x * x + q.y * y + q.z * z + q.one;
    c->slope[k] = std::sqrt(gx * gx + gy * gy + gz * gz);
  }
}

/// dr/dq = (v − r ∇vᵀ g / |g|) / |g| with g the gradient, whose halves are in the chunk.
QUADRILLE_VECTOR_CLONES
void differentiate(const Chunk& c, float min_slope, Jacobian* J) {
  auto& col = J->column;
  for (int k = 0; k < kChunk; ++k) {
    const float x = c.x[k], y = c.y[k], z = c.z[k];
    const float inverse = 0.5f / std::max(c.slope[k], min_slope);
    const float r = c.f[k] * inverse;
    const float s = 2.0f * r * inverse;
    const float rx = s * c.gx[k], ry = s * c.gy[k], rz = s * c.gz[k];
    const float twice = 2.0f * inverse;
    col[0][k] = x * (x - 2.0f * rx) * inverse;
    col[1][k] = y * (y - 2.0f * ry) * inverse;
    col[2][k] = z * (z - 2.0f * rz) * inverse;
    col[3][k] = (x * y - y * rx - x * ry) * twice;
    col[4][k] = (x * z - z * rx - x * rz) * twice;
    col[5][k] = (y * z - z * ry - y * rz) * twice;
    col[6][k] = (x - rx) * twice;
    col[7][k] = (y - ry) * twice;
    col[8][k] = (z - rz) * twice;
    col[9][k] = inverse;
    col[10][k] = r;
  }
}

/// Row a of JᵀJ, from the diagonal on. With `a` known the sums stay in registers.
template <int a>
inline __attribute__((always_inline)) void add_row(const Jacobian& J, int size, double* N) {
  Strands sum[kColumns - a] = {};
  for (int k = 0; k < size; k += kLanes) {
    const Strands left = reinterpret_cast<const Strands&>(J.column[a][k]);
    for (int b = a; b < kColumns; ++b)
      sum[b - a] += left * reinterpret_cast<const Strands&>(J.column[b][k]);
  }
  for (int b = a; b < kColumns; ++b) {
    const Strands& s = sum[b - a];
    N[a * kColumns + b] += (s[0] + s[4]) + (s[1] + s[5]) + ((s[2] + s[6]) + (s[3] + s[7]));
  }
}

/// Adds JᵀJ, upper triangle.
QUADRILLE_VECTOR_CLONES
void add_products(const Jacobian& J, int size, double* N) {
  add_row<0>(J, size, N), add_row<1>(J, size, N), add_row<2>(J, size, N);
  add_row<3>(J, size, N), add_row<4>(J, size, N), add_row<5>(J, size, N);
  add_row<6>(J, size, N), add_row<7>(J, size, N), add_row<8>(J, size, N);
  add_row<9>(J, size, N), add_row<10>(J, size, N);
}

void clear_beyond(int size, Jacobian* J) {
  for (auto& column : J->column) std::fill(column + size, column + kChunk, 0.0f);
}

/// The points in chunks, with f and its gradient.
class Evaluation {
 public:
  Evaluation(const FitPoints& points, const Eigen::Matrix4d& Q)
      : size_(static_cast<std::size_t>((points.size() + kChunk - 1) / kChunk)),
        chunks_(std::make_unique_for_overwrite<Chunk[]>(size_)) {
    const Coefficients q(Q);
    double slopes = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      Chunk& chunk = chunks_[i];
      chunk.load(points, static_cast<int>(i) * kChunk);
      evaluate(q, &chunk);
      slopes += Eigen::Map<const Eigen::ArrayXf>(chunk.slope, chunk.size).sum();
    }
    const double n = std::max(1.0, static_cast<double>(points.size()));
    min_slope_ = std::max(1e-20f, kWeakGradient * static_cast<float>(slopes / n));
  }
  std::span<const Chunk> chunks() const { return {chunks_.get(), size_}; }
  float min_slope() const { return min_slope_; }

 private:
  std::size_t size_;
  std::unique_ptr<Chunk[]> chunks_;
  float min_slope_;
};

}  // namespace

Eigen::Matrix<double, 11, 11> normal_equations(const FitPoints& points, const Eigen::Matrix4d& Q) {
  const Evaluation evaluation(points, Q);
  Eigen::Matrix<double, 11, 11, Eigen::RowMajor> N;
  N.setZero();
  Jacobian J;
  for (const Chunk& chunk : evaluation.chunks()) {
    differentiate(chunk, evaluation.min_slope(), &J);
    clear_beyond(chunk.size, &J);
    add_products(J, chunk.size, N.data());
  }
  return N.selfadjointView<Eigen::Upper>();
}

double sum_of_squares(const FitPoints& points, const Eigen::Matrix4d& Q) {
  const Evaluation evaluation(points, Q);
  double sum = 0;
  for (const Chunk& chunk : evaluation.chunks()) {
    const auto f = Eigen::Map<const Eigen::ArrayXf>(chunk.f, chunk.size);
    const auto slope = Eigen::Map<const Eigen::ArrayXf>(chunk.slope, chunk.size);
    sum += 0.25 * static_cast<double>((f / slope.max(evaluation.min_slope())).square().sum());
  }
  return sum;
}

}  // namespace quadrille

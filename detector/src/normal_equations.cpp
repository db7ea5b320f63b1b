#include "normal_equations.hpp"

#include <algorithm>
#include <cmath>

#include "vector_clones.hpp"

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
void differentiate(const Chunk& c, float least_slope, Jacobian* J) {
  auto& col = J->column;
  for (int k = 0; k < kChunk; ++k) {
    const float x = c.x[k], y = c.y[k], z = c.z[k];
    const float inverse = 0.5f / std::max(c.slope[k], least_slope);
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

/// Adds JᵀJ, upper triangle.
QUADRILLE_VECTOR_CLONES
void add_products(const Jacobian& J, int size, double* N) {
  for (int a = 0; a < kColumns; ++a) {
    for (int b = a; b < kColumns; ++b) {
      const float* left = J.column[a];
      const float* right = J.column[b];
      float lane[kLanes] = {};
      for (int k = 0; k < size; k += kLanes) {
        for (int l = 0; l < kLanes; ++l) lane[l] += left[k + l] * right[k + l];
      }
      N[a * kColumns + b] += (lane[0] + lane[4]) + (lane[1] + lane[5]) +
                             ((lane[2] + lane[6]) + (lane[3] + lane[7]));
    }
  }
}

void clear_beyond(int size, Jacobian* J) {
  for (auto& column : J->column) std::fill(column + size, column + kChunk, 0.0f);
}

float least_slope(const FitPoints& points, const Coefficients& q) {
  const int n = static_cast<int>(points.size());
  Chunk chunk;
  double sum = 0;
  for (int first = 0; first < n; first += kChunk) {
    chunk.load(points, first);
    evaluate(q, &chunk);
    sum += Eigen::Map<const Eigen::ArrayXf>(chunk.slope, chunk.size).sum();
  }
  return std::max(1e-20f, kWeakGradient * static_cast<float>(sum / std::max(1, n)));
}

}  // namespace

Eigen::Matrix<double, 11, 11> normal_equations(const FitPoints& points, const Eigen::Matrix4d& Q) {
  const Coefficients q(Q);
  const float least = least_slope(points, q);
  Eigen::Matrix<double, 11, 11, Eigen::RowMajor> N;
  N.setZero();
  Chunk chunk;
  Jacobian J;
  for (int first = 0; first < points.size(); first += kChunk) {
    chunk.load(points, first);
    evaluate(q, &chunk);
    differentiate(chunk, least, &J);
    clear_beyond(chunk.size, &J);
    add_products(J, chunk.size, N.data());
  }
  return N.selfadjointView<Eigen::Upper>();
}

double sum_of_squares(const FitPoints& points, const Eigen::Matrix4d& Q) {
  const Coefficients q(Q);
  const float least = least_slope(points, q);
  Chunk chunk;
  double sum = 0;
  for (int first = 0; first < points.size(); first += kChunk) {
    chunk.load(points, first);
    evaluate(q, &chunk);
    const auto f = Eigen::Map<const Eigen::ArrayXf>(chunk.f, chunk.size);
    const auto slope = Eigen::Map<const Eigen::ArrayXf>(chunk.slope, chunk.size);
    sum += 0.25 * static_cast<double>((f / slope.max(least)).square().sum());
  }
  return sum;
}

}  // namespace quadrille

#include "fit/distance_sums.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "fit/column_products.hpp"
#include "fit/half_gradient.hpp"

namespace quadrille {
namespace {

// Near an apex or a centre the gradient vanishes and the first-order distance explodes, so the
// gradient's length counts as at least this share of its mean.
constexpr float kWeakGradient = 0.05f;
constexpr int kColumns = 11;

}  // namespace

/// A chunk of points; the coordinates beyond the last point are zero.
template <typename Scalar>
struct alignas(kLanes * sizeof(Scalar)) PointChunk {
  Scalar x[kChunk], y[kChunk], z[kChunk];
  /// Half gradients, their length, and f.
  Scalar gx[kChunk], gy[kChunk], gz[kChunk], slope[kChunk], f[kChunk];
  int size = 0;

  void load(const OrientedPoints<Scalar>& p, int first) {
    size = std::min(kChunk, static_cast<int>(p.size()) - first);
    const auto copy = [&](const auto& from, Scalar* to) {
      std::copy_n(from.data() + first, size, to);
      std::fill(to + size, to + kChunk, Scalar(0));
    };
    copy(p.x(), x), copy(p.y(), y), copy(p.z(), z);
  }
};

namespace {

template <typename Scalar>
using Jacobian = ChunkColumns<Scalar, kColumns>;

template <typename Scalar>
QUADRILLE_INTO_CLONES void evaluate_points(const Coefficients<Scalar>& q, PointChunk<Scalar>* c) {
  for (int k = 0; k < kChunk; ++k) {
    const HalfGradient<Scalar> g = half_gradient(q, c->x[k], c->y[k], c->z[k]);
    c->gx[k] = g.x, c->gy[k] = g.y, c->gz[k] = g.z;
    c->f[k] = g.f;
    c->slope[k] = std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z);
  }
}

/// The derivative dr/dq = (v − r ∇vᵀ g / |g|) / |g|, where g is the gradient; the chunk holds its
/// half.
template <typename Scalar>
QUADRILLE_INTO_CLONES void differentiate_points(const PointChunk<Scalar>& c, Scalar min_slope,
                                                Jacobian<Scalar>* J) {
  const Scalar half(0.5), two(2);
  auto& col = J->column;
  for (int k = 0; k < kChunk; ++k) {
    const Scalar x = c.x[k], y = c.y[k], z = c.z[k];
    const Scalar inverse = half / std::max(c.slope[k], min_slope);
    const Scalar r = c.f[k] * inverse;
    const Scalar s = two * r * inverse;
    const Scalar rx = s * c.gx[k], ry = s * c.gy[k], rz = s * c.gz[k];
    const Scalar twice = two * inverse;
    col[0][k] = x * (x - two * rx) * inverse;
    col[1][k] = y * (y - two * ry) * inverse;
    col[2][k] = z * (z - two * rz) * inverse;
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

/// The sum of r², in the same order as the last element of JᵀJ.
template <typename Scalar>
QUADRILLE_INTO_CLONES double square_of_points(const PointChunk<Scalar>& c, Scalar min_slope) {
  alignas(kLanes * sizeof(Scalar)) Scalar r[kChunk];
  for (int k = 0; k < kChunk; ++k) {
    r[k] = c.f[k] * (Scalar(0.5) / std::max(c.slope[k], min_slope));
  }
  typename LanesOf<Scalar>::Type sum = {};
  for (int k = 0; k < c.size; k += kLanes) {
    const auto v = reinterpret_cast<const typename LanesOf<Scalar>::Type&>(r[k]);
    sum += v * v;
  }
  return sum_of_lanes(sum);
}

QUADRILLE_VECTOR_CLONES
void evaluate_at(Coefficients<float> q, PointChunk<float>* c) { evaluate_points(q, c); }
void evaluate_at(Coefficients<double> q, PointChunk<double>* c) { evaluate_points(q, c); }

QUADRILLE_VECTOR_CLONES
void differentiate(const PointChunk<float>& c, float min_slope, Jacobian<float>* J) {
  differentiate_points(c, min_slope, J);
}
void differentiate(const PointChunk<double>& c, double min_slope, Jacobian<double>* J) {
  differentiate_points(c, min_slope, J);
}

QUADRILLE_VECTOR_CLONES
double sum_squares(const PointChunk<float>& c, float min_slope) {
  return square_of_points(c, min_slope);
}
double sum_squares(const PointChunk<double>& c, double min_slope) {
  return square_of_points(c, min_slope);
}

QUADRILLE_VECTOR_CLONES
void add_products(const Jacobian<float>& J, int size, double* N) { add_rows(J, size, N); }
void add_products(const Jacobian<double>& J, int size, double* N) { add_rows(J, size, N); }

/// The number of points, rounded up to whole vectors.
int padded(int size) { return (size + kLanes - 1) / kLanes * kLanes; }

}  // namespace

template <typename Scalar>
DistanceSums<Scalar>::DistanceSums(const OrientedPoints<Scalar>& points)
    : points_(points.size()),
      chunks_(std::make_unique_for_overwrite<PointChunk<Scalar>[]>(
          static_cast<std::size_t>((points.size() + kChunk - 1) / kChunk))) {
  int first = 0;
  for (PointChunk<Scalar>& chunk : chunks()) {
    chunk.load(points, first);
    first += kChunk;
  }
}

template <typename Scalar>
DistanceSums<Scalar>::~DistanceSums() = default;

template <typename Scalar>
std::span<PointChunk<Scalar>> DistanceSums<Scalar>::chunks() const {
  return {chunks_.get(), static_cast<std::size_t>((points_ + kChunk - 1) / kChunk)};
}

template <typename Scalar>
DistanceSums<Scalar>& DistanceSums<Scalar>::evaluate(const Eigen::Matrix4d& Q) {
  using Map = Eigen::Map<const Eigen::Array<Scalar, Eigen::Dynamic, 1>>;
  const Coefficients<Scalar> q(Q);
  double slopes = 0;
  for (PointChunk<Scalar>& chunk : chunks()) {
    evaluate_at(q, &chunk);
    slopes += static_cast<double>(Map(chunk.slope, chunk.size).sum());
    // The places that fill up the last vector count as points on the quadric.
    for (int k = chunk.size; k < padded(chunk.size); ++k) chunk.f[k] = 0;
  }
  const double n = std::max(1.0, static_cast<double>(points_));
  min_slope_ = std::max(Scalar(1e-20), Scalar(kWeakGradient) * static_cast<Scalar>(slopes / n));
  return *this;
}

template <typename Scalar>
double DistanceSums<Scalar>::squares() const {
  double sum = 0;
  for (const PointChunk<Scalar>& chunk : chunks()) sum += sum_squares(chunk, min_slope_);
  return sum;
}

template <typename Scalar>
Matrix11d DistanceSums<Scalar>::normal_equations() const {
  return products(false);
}

template <typename Scalar>
Matrix11d DistanceSums<Scalar>::offset_equations() const {
  return products(true);
}

template <typename Scalar>
Matrix11d DistanceSums<Scalar>::products(bool ones) const {
  Eigen::Matrix<double, 11, 11, Eigen::RowMajor> N;
  N.setZero();
  Jacobian<Scalar> J;
  for (const PointChunk<Scalar>& chunk : chunks()) {
    differentiate(chunk, min_slope_, &J);
    if (ones) std::fill_n(J.column[kColumns - 1], chunk.size, Scalar(1));
    J.clear_beyond(chunk.size);
    add_products(J, chunk.size, N.data());
  }
  return N.template selfadjointView<Eigen::Upper>();
}

template class DistanceSums<float>;
template class DistanceSums<double>;

}  // namespace quadrille

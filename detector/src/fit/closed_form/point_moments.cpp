#include "fit/closed_form/point_moments.hpp"

#include <algorithm>

#include "fit/column_products.hpp"

namespace quadrille {
namespace {

// Lengths of the vectors v and h whose products are summed.
constexpr int kValues = 10, kLines = 8;

/// The monomials of the points of a chunk.
QUADRILLE_VECTOR_CLONES
void add_values(const float* x, const float* y, const float* z, int size, double* S) {
  ChunkColumns<float, kValues> v;
  auto& c = v.column;
  for (int k = 0; k < size; ++k) {
    const float twice_x = 2.0f * x[k], twice_y = 2.0f * y[k];
    c[0][k] = x[k] * x[k], c[1][k] = y[k] * y[k], c[2][k] = z[k] * z[k];
    c[3][k] = twice_x * y[k], c[4][k] = twice_x * z[k], c[5][k] = twice_y * z[k];
    c[6][k] = twice_x, c[7][k] = twice_y, c[8][k] = 2.0f * z[k];
    c[9][k] = 1.0f;
  }
  v.clear_beyond(size);
  add_rows(v, size, S);
}

QUADRILLE_VECTOR_CLONES
void add_lines(const float* x, const float* y, const float* z, const float* nx, const float* ny,
               const float* nz, int size, double* S) {
  ChunkColumns<float, kLines> h;
  auto& c = h.column;
  for (int k = 0; k < size; ++k) {
    c[0][k] = y[k] * nz[k] - z[k] * ny[k];
    c[1][k] = z[k] * nx[k] - x[k] * nz[k];
    c[2][k] = x[k] * ny[k] - y[k] * nx[k];
    c[3][k] = nx[k], c[4][k] = ny[k], c[5][k] = nz[k];
    c[6][k] = nx[k] * x[k] + ny[k] * y[k] + nz[k] * z[k];
    c[7][k] = 1.0f;
  }
  h.clear_beyond(size);
  add_rows(h, size, S);
}

template <int size>
using Sums = Eigen::Matrix<double, size, size, Eigen::RowMajor>;

}  // namespace

PointMoments::PointMoments(const OrientedPointsf& p) : size(p.size()) {
  Sums<kValues> v = Sums<kValues>::Zero();
  Sums<kLines> h = Sums<kLines>::Zero();
  for (Eigen::Index first = 0; first < size; first += kChunk) {
    const int count = static_cast<int>(std::min<Eigen::Index>(kChunk, size - first));
    const float *x = p.x().data() + first, *y = p.y().data() + first, *z = p.z().data() + first;
    add_values(x, y, z, count, v.data());
    add_lines(x, y, z, p.nx().data() + first, p.ny().data() + first, p.nz().data() + first, count,
              h.data());
  }
  values = v.selfadjointView<Eigen::Upper>();
  normals = h.selfadjointView<Eigen::Upper>();
}

Eigen::Matrix3d PointMoments::scatter() const {
  const double xy = 0.5 * values(3, 9), xz = 0.5 * values(4, 9), yz = 0.5 * values(5, 9);
  Eigen::Matrix3d S;
  S << values(0, 9), xy, xz, xy, values(1, 9), yz, xz, yz, values(2, 9);
  return S;
}

Vector10d quadratic(const Eigen::Matrix3d& A, const Eigen::Vector3d& b, double j) {
  Vector10d c;
  c << A(0, 0), A(1, 1), A(2, 2), A(0, 1), A(0, 2), A(1, 2), b, j;
  return c;
}

}  // namespace quadrille

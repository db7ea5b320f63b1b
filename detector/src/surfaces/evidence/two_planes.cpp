#include "surfaces/evidence/two_planes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fit/column_products.hpp"
#include "samples/plane_sums.hpp"
#include "samples/region.hpp"

namespace quadrille {
namespace {

// Rounds of 2-means and of Lloyd's algorithm, after which few samples still change sides.
constexpr int kNormalRounds = 5, kDistanceRounds = 4;
// More samples do not improve the planes.
constexpr std::size_t kMaxSamples = 400;
// Used as the plane of too few samples; it is so far away that no sample is nearer to it than to
// the other plane.
const Eigen::Vector4d kFarPlane(0, 0, 0, 1e3);

/// Vectors of a chunk of samples, either positions or normals, and the sides on which they are: one
/// or zero.
struct SidedChunk {
  float x[kChunk], y[kChunk], z[kChunk];
  float side[kChunk];
  int size = 0;
};

/// Sums over the vectors v of one side: of 1 and v in the first row, and of v vᵀ below and right of
/// it.
using SideSums = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

/// Puts vectors on side one if (v, 1)·plane is positive.
QUADRILLE_VECTOR_CLONES
void divide(const float* plane, SidedChunk* c) {
  const float px = plane[0], py = plane[1], pz = plane[2], offset = plane[3];
  for (int k = 0; k < kChunk; ++k) {
    c->side[k] = px * c->x[k] + py * c->y[k] + pz * c->z[k] + offset > 0.0f ? 1.0f : 0.0f;
  }
}

/// Puts positions on the side of the nearer plane.
/// @return sum of the squares of their distances from it
QUADRILLE_VECTOR_CLONES
double divide_between(const float* first, const float* second, SidedChunk* c) {
  const float ax = first[0], ay = first[1], az = first[2], a0 = first[3];
  const float bx = second[0], by = second[1], bz = second[2], b0 = second[3];
  ChunkColumns<float, 1> distance;
  for (int k = 0; k < kChunk; ++k) {
    const float a = std::abs(ax * c->x[k] + ay * c->y[k] + az * c->z[k] + a0);
    const float b = std::abs(bx * c->x[k] + by * c->y[k] + bz * c->z[k] + b0);
    c->side[k] = b < a ? 1.0f : 0.0f;
    distance.column[0][k] = std::min(a, b);
  }
  distance.clear_beyond(c->size);
  double sum = 0.0;
  add_rows(distance, c->size, &sum);
  return sum;
}

QUADRILLE_VECTOR_CLONES
void add_side(const SidedChunk& c, double* sums) {
  ChunkColumns<float, 4> columns;
  for (int k = 0; k < kChunk; ++k) {
    columns.column[0][k] = c.side[k];
    columns.column[1][k] = c.side[k] * c.x[k];
    columns.column[2][k] = c.side[k] * c.y[k];
    columns.column[3][k] = c.side[k] * c.z[k];
  }
  columns.clear_beyond(c.size);
  add_rows(columns, c.size, sums);
}

/// Vectors of samples that are divided in two.
class DividedVectors {
 public:
  /// @param vector_of  vector_of(sample), a vector
  template <class VectorOf>
  DividedVectors(std::span<const int> list, VectorOf&& vector_of)
      : chunks_((list.size() + kChunk - 1) / kChunk) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      SidedChunk& chunk = chunks_[k / kChunk];
      const Eigen::Vector3f v = vector_of(list[k]);
      const int place = chunk.size++;
      chunk.x[place] = v.x(), chunk.y[place] = v.y(), chunk.z[place] = v.z();
      chunk.side[place] = 1.0f;
    }
    all_ = sums();
  }

  const SideSums& all() const { return all_; }
  /// Sums over side one. Those over side zero are the rest of all.
  SideSums sums() const {
    SideSums sums = SideSums::Zero();
    for (const SidedChunk& chunk : chunks_) add_side(chunk, sums.data());
    return sums;
  }
  void divide_by(const Eigen::Vector4f& plane) {
    for (SidedChunk& chunk : chunks_) divide(plane.data(), &chunk);
  }
  double divide_by(const Eigen::Vector4f& first, const Eigen::Vector4f& second) {
    double squares = 0.0;
    for (SidedChunk& chunk : chunks_) {
      squares += divide_between(first.data(), second.data(), &chunk);
    }
    return squares;
  }
  /// Takes the sides of the same samples.
  void divide_like(const DividedVectors& other) {
    for (std::size_t c = 0; c < chunks_.size(); ++c) {
      std::copy_n(other.chunks_[c].side, kChunk, chunks_[c].side);
    }
  }

 private:
  std::vector<SidedChunk> chunks_;
  SideSums all_;
};

/// The plane through positions near the origin, where subtracting the mean from the sums loses no
/// accuracy.
Eigen::Vector4f plane_of(const SideSums& sums) {
  const double n = sums(0, 0);
  if (n < 2.5) return kFarPlane.cast<float>();
  const Eigen::Vector3d sum = sums.row(0).tail<3>();
  const Eigen::Matrix3d squares = sums.bottomRightCorner<3, 3>().selfadjointView<Eigen::Upper>();
  const Eigen::Vector3d m = min_spread_direction(squares / n - sum * sum.transpose() / (n * n));
  return Eigen::Vector4d(m.x(), m.y(), m.z(), -m.dot(sum) / n).cast<float>();
}

/// The normal that differs most from a direction.
Eigen::Vector3f farthest_normal(const SurfaceSamples& samples, std::span<const int> region,
                                const Eigen::Vector3f& from) {
  int best = region[0];
  float least = samples.n[best].dot(from);
  for (const int i : region) {
    const float along = samples.n[i].dot(from);
    if (along < least) best = i, least = along;
  }
  return samples.n[best];
}

/// Divides a region in two by its normals, with 2-means that starts from two very different
/// normals.
DividedVectors divided_by_normals(const SurfaceSamples& samples, std::span<const int> region) {
  DividedVectors normals(region, [&](int i) { return samples.n[i]; });
  const auto mean_of = [](const SideSums& sums) {
    return Eigen::Vector3f(sums.row(0).tail<3>().cast<float>());
  };
  std::array<Eigen::Vector3f, 2> centre;
  centre[0] = farthest_normal(samples, region, mean_of(normals.all()));
  centre[1] = farthest_normal(samples, region, centre[0]);
  for (int round = 0; round < kNormalRounds; ++round) {
    const Eigen::Vector3f between = centre[1] - centre[0];
    normals.divide_by(Eigen::Vector4f(between.x(), between.y(), between.z(), 0.0f));
    const SideSums one = normals.sums();
    const std::array<Eigen::Vector3f, 2> sum = {mean_of(normals.all() - one), mean_of(one)};
    for (std::size_t c = 0; c < 2; ++c) {
      if (sum[c].norm() > 0) centre[c] = sum[c].normalized();
    }
  }
  return normals;
}

}  // namespace

double two_planes_rss(const SurfaceSamples& samples, std::span<const int> region) {
  const std::vector<int> some = spread_evenly(region, kMaxSamples);
  const Eigen::Vector3f origin = samples.raw[some[0]];
  DividedVectors positions(some, [&](int i) { return samples.raw[i] - origin; });
  positions.divide_like(divided_by_normals(samples, some));
  // Near an edge the smoothed normals lie between those of the faces, so from here on the distance
  // decides.
  double rss = 0;
  for (int round = 0; round < kDistanceRounds; ++round) {
    const SideSums one = positions.sums();
    rss = positions.divide_by(plane_of(positions.all() - one), plane_of(one));
  }
  return rss * static_cast<double>(region.size()) / static_cast<double>(some.size());
}

}  // namespace quadrille

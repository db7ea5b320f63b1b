#include "samples/voxel/voxel_samples.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "samples/voxel/voxel_noise.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;
using Eigen::Vector3f;

namespace {

constexpr float kSampleEdge = 0.01f, kSigma = 0.0007f;
const Vector3f kNormal = Vector3f(0.3f, -0.2f, 1.0f).normalized();

/// The plane through (1, 2, 3) with that normal, a point about every half voxel, with noise [m].
std::vector<Vector3f> sloping_plane(double noise) {
  const Vector3f e1 = kNormal.unitOrthogonal(), e2 = kNormal.cross(e1);
  RandomStream random(5, 0);
  std::vector<Vector3f> points;
  for (int i = 0; i < 10000; ++i) {
    const float s = static_cast<float>(0.5 * random.uniform());
    const float t = static_cast<float>(0.5 * random.uniform());
    const float h = static_cast<float>(noise * gaussian(random));
    points.push_back(Vector3f(1, 2, 3) + s * e1 + t * e2 + h * kNormal);
  }
  return points;
}

}  // namespace

TEST_CASE("samples of a plane have its normal, lie on it, and keep what the voxels say",
          "[voxel]") {
  const VoxelGrid grid(sloping_plane(0.0), {}, kSampleEdge);
  Mask keep(static_cast<std::size_t>(grid.size()), 1);
  for (int v = 0; v < grid.size(); v += 5) keep[v] = 0;
  for (const float side : {1.0f, -1.0f}) {
    const Vector3f eye = Vector3f(1, 2, 3) + side * kNormal;
    const SurfaceSamples samples = make_voxel_samples(grid, keep, kSigma, eye, 2.6f);
    REQUIRE(samples.size() > grid.size() / 2);
    for (int i = 0; i < samples.size(); ++i) {
      const int v = samples.source[i];
      REQUIRE(keep[v]);
      CHECK(side * samples.n[i].dot(kNormal) > 0.9999f);
      CHECK(std::abs(kNormal.dot(samples.p[i] - Vector3f(1, 2, 3))) < 1e-5f);
      CHECK(samples.raw[i] == grid.mean()[v]);
      CHECK(samples.count[i] == grid.count()[v]);
      CHECK(samples.sigma[i] == kSigma);
      CHECK(samples.cell[i] == kSampleEdge);
      for (const int j : samples.neighbours_of(i)) {
        CHECK(j != i);
        CHECK((samples.raw[j] - samples.raw[i]).norm() < 2 * kSampleEdge);
      }
    }
  }
}

TEST_CASE("no voxel kept gives no samples, and points on a line no normal", "[voxel][degenerate]") {
  const VoxelGrid grid(sloping_plane(0.0), {}, kSampleEdge);
  const Mask none(static_cast<std::size_t>(grid.size()), 0);
  CHECK(make_voxel_samples(grid, none, kSigma, Vector3f::Zero(), 2.6f).size() == 0);
  std::vector<Vector3f> line;
  for (int i = 0; i < 1000; ++i) line.emplace_back(0.001f * static_cast<float>(i), 0.0f, 1.0f);
  const VoxelGrid thin(line, {}, kSampleEdge);
  const Mask all(static_cast<std::size_t>(thin.size()), 1);
  CHECK(make_voxel_samples(thin, all, kSigma, Vector3f::Zero(), 2.6f).size() == 0);
}

TEST_CASE("the noise of voxels' means is that of their points over the root of their number",
          "[voxel][noise]") {
  // A plane through the middles of a layer of voxels: none is grazed, each has about 40 points.
  // What is measured is a low quantile over patches, somewhat below the mean.
  for (const double noise : {0.0008, 0.001, 0.0012}) {
    RandomStream random(7, 0);
    std::vector<Vector3f> points;
    for (int i = 0; i < 100000; ++i) {
      const double x = 0.5 * random.uniform(), y = 0.5 * random.uniform();
      points.push_back(Eigen::Vector3d(x, y, 0.505 + noise * gaussian(random)).cast<float>());
    }
    const VoxelGrid grid(points, {}, kSampleEdge);
    double variance = 0.0;
    for (const int count : grid.count()) variance += noise * noise / count / grid.size();
    CHECK(measure_voxel_noise(grid, {}) == Approx(std::sqrt(variance)).epsilon(0.2));
  }
  CHECK(measure_voxel_noise(VoxelGrid({}, {}, kSampleEdge), {}) == Approx(0.001));
}

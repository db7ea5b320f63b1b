#include "samples/cell_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kRadius = 0.06;

/// Balls on a table as cameras around it see them, in the frame of the first, pixel by pixel.
PointCloud balls_seen_from(const std::vector<Eigen::Vector3d>& eyes) {
  Camera camera;
  camera.noise = 0.001;
  PointCloud fused;
  for (const Eigen::Vector3d& eye : eyes) {
    const Eigen::Isometry3d X_CW = world_seen_from(eye);
    std::vector<Patch> patches = {rectangle(X_CW, 0.4, 0.4)};
    for (const double x : {-0.2, 0.0, 0.2}) {
      patches.push_back(sphere(X_CW * translation(x, 0.05, kRadius), kRadius));
    }
    const Eigen::Isometry3d X = world_seen_from(eyes[0]) * X_CW.inverse();
    for (const Eigen::Vector3f& p : render(patches, camera).points) {
      if (p.allFinite()) fused.points.push_back(X.cast<float>() * p);
    }
  }
  return fused;
}

/// Points all over a sphere, evenly (golden spiral), the viewpoint far above.
PointCloud all_around(double noise) {
  PointCloud cloud;
  cloud.viewpoint = {0, 0, 2};
  RandomStream random(91, 0);
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double z = 1 - (2 * i + 1.0) / kCount, a = i * M_PI * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    const Eigen::Vector3d n(r * std::cos(a), r * std::sin(a), z);
    cloud.points.push_back(((kRadius + noise * gaussian(random)) * n).cast<float>());
  }
  return cloud;
}

/// Compares the points that are visited with the cells of the points one by one; every third cell
/// has no owner.
void check_visits(const CellPyramid& pyramid, const PointCloud& cloud) {
  // It has no factor in common with the owners, or in cells of one pixel all points would have
  // none.
  constexpr std::size_t kStep = 5;
  std::vector<int> owner(static_cast<std::size_t>(pyramid.size(0)), 0);
  for (std::size_t c = 0; c < owner.size(); c += 3) owner[c] = -1;
  std::vector<std::pair<std::size_t, int>> expected, visited;
  for (std::size_t k = 0; k < cloud.points.size(); k += kStep) {
    const int cell = pyramid.cell_of(cloud.points[k]);
    if (cell >= 0 && owner[cell] >= 0) expected.emplace_back(k, cell);
  }
  pyramid.visit_points(cloud, kStep, owner,
                       [&](std::size_t k, int cell) { visited.emplace_back(k, cell); });
  CHECK(expected.size() > cloud.points.size() / kStep / 3);
  CHECK(visited == expected);
}

/// A cloud of whose points some lie behind those that made the cells, some beside the image or
/// behind the sensor, and some nowhere.
PointCloud disturbed(PointCloud cloud) {
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    Eigen::Vector3f& p = cloud.points[k];
    if (k % 4 == 0) p *= 1.5f;
    if (k % 7 == 0) p.setConstant(std::numeric_limits<float>::quiet_NaN());
    if (k % 11 == 0) p.x() += 5.0f;
    if (k % 13 == 0) p = -p;
  }
  return cloud;
}

/// What holds of a pyramid of either kind.
void check_pyramid(const CellPyramid& pyramid, const PointCloud& cloud) {
  const std::size_t points = cloud.points.size();
  std::size_t total = 0;
  for (int c = 0; c < pyramid.size(0); ++c) {
    total += static_cast<std::size_t>(pyramid.count(c));
    if (pyramid.count(c) == 0) continue;
    REQUIRE(pyramid.mean(c).allFinite());
    REQUIRE(pyramid.sigma(c) > 0.0f);
    const auto [least, most] = pyramid.sigma_bounds(c);
    REQUIRE(least <= pyramid.sigma(c));
    REQUIRE(most >= pyramid.sigma(c));
    if (pyramid.view()) REQUIRE(most < 1.2f * least);
  }
  CHECK(total <= points);
  CHECK(total > points * 95 / 100);
  check_visits(pyramid, cloud);
  for (int l = 0; l + 1 < kLevels; ++l) {
    CHECK(pyramid.size(l + 1) < pyramid.size(l));
    for (int c = 0; c < pyramid.size(l); ++c) {
      REQUIRE(pyramid.parents(l)[c] >= 0);
      REQUIRE(pyramid.parents(l)[c] < pyramid.size(l + 1));
    }
  }
  const Mask keep(static_cast<std::size_t>(pyramid.size(0)), 1);
  const auto one = pyramid.samples(keep, 1), three = pyramid.samples(keep, 3);
  REQUIRE(one.size() == kLevels);
  for (int l = 0; l < kLevels; ++l) {
    CHECK(one[l].size() > 0);
    CHECK(one[l].raw == three[l].raw);
    CHECK(one[l].n == three[l].n);
    CHECK(one[l].neighbours == three[l].neighbours);
    if (l > 0) CHECK(one[l].cell[0] == Approx(2 * one[l - 1].cell[0]).epsilon(0.2));
  }
}

}  // namespace

TEST_CASE("a single view becomes a pyramid of depth cells", "[pyramid]") {
  const PointCloud cloud = render({rectangle(translation(0, 0, 1.0), 1e3, 1e3)});
  const auto pyramid = make_depth_pyramid(cloud, {});
  REQUIRE(pyramid);
  check_pyramid(*pyramid, cloud);
  const PointCloud other = disturbed(cloud);
  check_visits(*pyramid, other);
  // Behind the wall there is no cell, though the ray goes through one.
  CHECK(pyramid->cell_of(other.points[4]) < 0);
  CHECK(pyramid->cell_of(cloud.points[4]) >= 0);
  // 3.1 mm cells at 1 m are one pixel of 3.3 mm.
  CHECK(pyramid->size(0) == 320 * 240);
  CHECK(make_pyramid(cloud, {})->size(0) == pyramid->size(0));
}

TEST_CASE("a large image of a far scene has no more cells than the setting allows", "[pyramid]") {
  Camera camera;
  camera.width = 640, camera.height = 480, camera.pitch = 1.0 / 525.0;
  // 3.1 mm at 1.5 m are about one of its 307,200 pixels; cells of two by two are few enough.
  const PointCloud far = render({rectangle(translation(0, 0, 1.5), 1e3, 1e3)}, camera);
  CHECK(make_depth_pyramid(far, {})->size(0) == 320 * 240);
  SamplingOptions many;
  many.max_cells = 400'000;
  CHECK(make_depth_pyramid(far, many)->size(0) == 640 * 480);
  SamplingOptions few;
  few.max_cells = 10'000;
  CHECK(make_depth_pyramid(far, few)->size(0) <= 12'000);
}

TEST_CASE("noise that outweighs the finest cells doubles them, unless means remove it",
          "[pyramid]") {
  Camera camera;
  camera.noise = 0.006;
  PointCloud white = render({rectangle(translation(0, 0, 1.0), 1e3, 1e3)}, camera);
  CHECK(make_depth_pyramid(white, {})->size(0) == 320 * 240);
  // Waves as long as the means are wide: some 15 pixels.
  PointCloud waves = render({rectangle(translation(0, 0, 1.0), 1e3, 1e3)});
  for (Eigen::Vector3f& p : waves.points) {
    const float u = p.x() / p.z(), v = p.y() / p.z();
    p *= 1.0f + 0.01f * std::sin(120.0f * u) * std::sin(120.0f * v);
  }
  CHECK(make_depth_pyramid(waves, {})->size(0) == 160 * 120);
}

TEST_CASE("a cloud fused from two sides has no depth grid and becomes voxels", "[pyramid]") {
  const PointCloud cloud = all_around(0.0);
  CHECK_FALSE(make_depth_pyramid(cloud, {}));
  const auto pyramid = make_pyramid(cloud, {});
  REQUIRE(pyramid);
  check_pyramid(*pyramid, cloud);
  // About one voxel per cell face of the surface 4πr², and more where it runs across them.
  const double faces = 4 * M_PI * kRadius * kRadius / (0.0031 * 0.0031);
  CHECK(pyramid->size(0) > faces);
  CHECK(pyramid->size(0) < 2.5 * faces);
}

TEST_CASE("a cloud fused from several views is no single view, whichever eye looks at it",
          "[pyramid]") {
  const Eigen::Vector3d a(0.0, -0.9, 0.6), b(0.8, 0.5, 0.6), c(-0.8, 0.5, 0.6);
  CHECK(make_depth_pyramid(balls_seen_from({a}), {}));
  for (const auto& eyes : {std::vector{a, b, c}, std::vector{b, c, a}, std::vector{a, b}}) {
    const PointCloud fused = balls_seen_from(eyes);
    CHECK_FALSE(make_depth_pyramid(fused, {}));
    CHECK(make_pyramid(fused, {}));
  }
}

TEST_CASE("normals of voxels are those of the sphere and look to the viewpoint's side",
          "[pyramid][voxel]") {
  const auto pyramid = make_voxel_pyramid(all_around(0.0002), {});
  REQUIRE(pyramid);
  const Mask keep(static_cast<std::size_t>(pyramid->size(0)), 1);
  for (const SurfaceSamples& level : pyramid->samples(keep, 1)) {
    std::vector<double> angle;
    for (int i = 0; i < level.size(); ++i) {
      const Eigen::Vector3d x = level.raw[i].cast<double>();
      const Eigen::Vector3d n = level.n[i].cast<double>();
      angle.push_back(std::acos(std::min(1.0, std::abs(n.dot(x.normalized())))));
      CHECK(n.dot(Eigen::Vector3d(0, 0, 2) - x) >= -1e-6);
      CHECK(level.neighbours_of(i).size() <= 8);
    }
    std::nth_element(angle.begin(), angle.begin() + static_cast<long>(angle.size() * 9 / 10),
                     angle.end());
    CHECK(angle[angle.size() * 9 / 10] < 6.0 * M_PI / 180.0);
  }
}

TEST_CASE("too small a cloud has no pyramid", "[pyramid][degenerate]") {
  PointCloud cloud = all_around(0.0);
  cloud.points.resize(49);
  CHECK_FALSE(make_pyramid(cloud, {}));
  CHECK_FALSE(make_pyramid(PointCloud(), {}));
  cloud.points.assign(5000, Eigen::Vector3f::Constant(NAN));
  CHECK_FALSE(make_pyramid(cloud, {}));
}

TEST_CASE("a single view tells what it sees along its rays, a cloud of many views does not",
          "[pyramid]") {
  const Eigen::Vector3d eye(0.0, -0.7, 0.5);
  const std::unique_ptr<CellPyramid> one = make_pyramid(balls_seen_from({eye}), {});
  const Sight sight = one->sight();
  REQUIRE(static_cast<int>(sight.w.size()) == one->size(0));
  CHECK(sight.width * sight.height == one->size(0));
  int seen = 0;
  for (int c = 0; c < one->size(0); ++c) {
    CHECK((sight.w[c] > 0.0f) == (one->count(c) > 0));
    if (one->count(c) == 0) continue;
    ++seen;
    // The mean of a cell's points lies within it, at that depth.
    const Eigen::Vector3f p = sight.X_VC * one->mean(c);
    REQUIRE(p.z() == Approx(1.0 / static_cast<double>(sight.w[c])).epsilon(1e-4));
    const Eigen::Array2f cell = (p.head<2>().array() / p.z() - sight.corner) / sight.step;
    REQUIRE(static_cast<int>(cell.x()) == c % sight.width);
    REQUIRE(static_cast<int>(cell.y()) == c / sight.width);
  }
  CHECK(seen > 1000);
  CHECK(make_pyramid(all_around(0.001), {})->sight().w.empty());
}

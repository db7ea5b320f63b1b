#include "samples/depth/depth_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

DepthCells cells_of(const std::vector<Patch>& patches, int pixels) {
  const PointCloud cloud = render(patches);
  const auto view = find_view(cloud);
  return make_depth_cells(cloud, *view, *find_image(cloud, *view), pixels);
}

SurfaceSamples samples_of(const DepthCells& cells, const Mask& keep = {}) {
  return make_depth_samples(cells, keep, NoiseModel(), Eigen::Isometry3f::Identity(), 2);
}

}  // namespace

TEST_CASE("normals and positions are exact on a tilted plane", "[depth][samples]") {
  Eigen::Isometry3d X = translation(0, 0, 1.2);
  X.rotate(Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 0.4, 0).normalized()));
  const SurfaceSamples samples = samples_of(cells_of({rectangle(X, 1e3, 1e3)}, 2));
  const Eigen::Vector3d n = -X.linear().col(2), at = X.translation();
  REQUIRE(samples.size() > 15000);
  for (int i = 0; i < samples.size(); ++i) {
    REQUIRE(samples.n[i].cast<double>().dot(n) > std::cos(2e-3));
    REQUIRE(std::abs(n.dot(samples.p[i].cast<double>() - at)) < 1e-4);
  }
}

TEST_CASE("normals of a sphere are right within two degrees and face the camera",
          "[depth][samples]") {
  const Eigen::Vector3d centre(0.05, -0.03, 0.8);
  const SurfaceSamples samples =
      samples_of(cells_of({sphere(Eigen::Isometry3d(Eigen::Translation3d(centre)), 0.1)}, 1));
  REQUIRE(samples.size() > 2000);
  int looked = 0;
  for (int i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d x = samples.raw[i].cast<double>();
    const Eigen::Vector3d n = (x - centre).normalized();
    CHECK(samples.n[i].dot(samples.raw[i]) < 0);
    // Within 60° of the line of sight; the windows at the rim are one-sided.
    if (n.dot(-x.normalized()) < 0.5) continue;
    ++looked;
    CHECK(samples.n[i].cast<double>().dot(n) > std::cos(2.0 * std::numbers::pi / 180.0));
  }
  CHECK(looked > 1000);
}

TEST_CASE("samples carry the noise at their depth, their cell's size and its points",
          "[depth][samples]") {
  const SurfaceSamples samples =
      samples_of(cells_of({rectangle(translation(0, 0, 1.5), 1e3, 1e3)}, 4));
  REQUIRE(samples.size() == 80 * 60);
  for (int i = 0; i < samples.size(); ++i) {
    REQUIRE(samples.sigma[i] == Approx(0.001 * 2.25).epsilon(1e-3));
    REQUIRE(samples.cell[i] == Approx(1.5 * 4 / 300).epsilon(1e-3));
    REQUIRE(samples.count[i] == 16);
    REQUIRE(samples.source[i] == i);
  }
}

TEST_CASE("neighbours are the eight cells around, but not across a depth edge",
          "[depth][samples]") {
  // A screen in front of the left half of a wall.
  const DepthCells cells = cells_of(
      {rectangle(translation(0, 0, 1.5), 1e3, 1e3), rectangle(translation(-5, 0, 1.0), 10, 1e3)},
      4);
  const SurfaceSamples samples = samples_of(cells);
  int full = 0;
  for (int i = 0; i < samples.size(); ++i) {
    full += samples.neighbours_of(i).size() == 8;
    for (const int j : samples.neighbours_of(i)) {
      REQUIRE(j != i);
      REQUIRE(std::abs(samples.raw[i].z() - samples.raw[j].z()) < 0.1f);
      const auto back = samples.neighbours_of(j);
      REQUIRE(std::find(back.begin(), back.end(), i) != back.end());
    }
  }
  CHECK(full == 2 * 38 * 58);
}

TEST_CASE("cells left out make no samples and no one's neighbours", "[depth][samples]") {
  const DepthCells cells = cells_of({rectangle(translation(0, 0, 1.5), 1e3, 1e3)}, 4);
  Mask keep(static_cast<std::size_t>(cells.size()), 1);
  for (int c = 0; c < cells.size(); ++c) keep[static_cast<std::size_t>(c)] = c % 80 < 40;
  const SurfaceSamples samples = samples_of(cells, keep);
  CHECK(samples.size() == 40 * 60);
  for (const int source : samples.source) REQUIRE(source % 80 < 40);
  std::fill(keep.begin(), keep.end(), 0);
  CHECK(samples_of(cells, keep).size() == 0);
}

TEST_CASE("samples stand in frame C by the pose of the view", "[depth][samples]") {
  const DepthCells cells = cells_of({sphere(translation(0, 0, 0.8), 0.1)}, 2);
  Eigen::Isometry3f X_CV = Eigen::Isometry3f::Identity();
  X_CV.rotate(Eigen::AngleAxisf(1.1f, Eigen::Vector3f(1, 2, 3).normalized()));
  X_CV.pretranslate(Eigen::Vector3f(1, 2, 3));
  const SurfaceSamples here = samples_of(cells);
  const SurfaceSamples there = make_depth_samples(cells, {}, NoiseModel(), X_CV, 2);
  REQUIRE(here.size() == there.size());
  for (int i = 0; i < here.size(); ++i) {
    CHECK((X_CV * here.raw[i] - there.raw[i]).norm() < 1e-6f);
    CHECK((X_CV * here.p[i] - there.p[i]).norm() < 1e-6f);
    CHECK((X_CV.linear() * here.n[i] - there.n[i]).norm() < 1e-6f);
  }
}

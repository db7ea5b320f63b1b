#include "samples/depth/noise.hpp"

#include <array>

#include "samples/depth/coarser_cells.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Noise of three levels of cells over what a camera sees.
std::vector<NoiseModel> noise_of(const std::vector<Patch>& patches, const Camera& camera,
                                 double quantile) {
  const PointCloud cloud = render(patches, camera);
  const auto view = find_view(cloud);
  std::array<DepthCells, 3> levels;
  levels[0] = make_depth_cells(cloud, *view, *find_image(cloud, *view), 1);
  levels[1] = coarser(levels[0], {});
  levels[2] = coarser(levels[1], {});
  NoiseOptions options;
  options.quantile = quantile;
  return measure_noise(levels, options);
}

Patch slope() {
  Eigen::Isometry3d X = translation(0, 0, 1.2);
  X.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()));
  return rectangle(X, 1e3, 1e3);
}

}  // namespace

TEST_CASE("the noise of the finest cells is recovered within a quarter", "[noise]") {
  for (const double sigma : {0.001, 0.003}) {
    Camera camera;
    camera.noise = sigma;
    for (const double quantile : {0.25, 0.5}) {
      const auto models = noise_of({slope()}, camera, quantile);
      REQUIRE(models.size() == 3);
      for (const float z : {0.9f, 1.2f, 1.6f}) {
        CAPTURE(sigma, quantile, z);
        CHECK(models[0].sigma(z) == Approx(sigma * z * z).epsilon(0.25));
      }
    }
  }
}

TEST_CASE("averages of four pixels have half the noise, and of sixteen a quarter", "[noise]") {
  Camera camera;
  camera.noise = 0.004;
  const auto models = noise_of({slope()}, camera, 0.5);
  CHECK(models[1].sigma(1.2f) == Approx(0.5 * 0.004 * 1.44).epsilon(0.12));
  CHECK(models[2].sigma(1.2f) == Approx(0.25 * 0.004 * 1.44).epsilon(0.12));
}

TEST_CASE("white noise has nothing in common, and what does not average out is all in common",
          "[noise]") {
  CHECK(common_share(0.002, 0.0005) == 0.0);
  CHECK(common_share(0.002, 0.002) == Approx(0.94).margin(0.01));
  CHECK(common_share(0.002, 0.004) == common_share(0.002, 0.002));
  CHECK(common_share(0.002, 0.0012) > 0.4);
  Camera camera;
  camera.noise = 0.004;
  const auto models = noise_of({slope()}, camera, 0.5);
  CHECK(common_share(models[0].sigma(1.2f), models[2].sigma(1.2f)) < 0.1);
}

TEST_CASE("curved surfaces do not count as noise", "[noise]") {
  Camera camera;
  camera.noise = 0.001;
  const auto models = noise_of({sphere(translation(0, 0, 1.0), 0.25)}, camera, 0.25);
  CHECK(models[0].sigma(0.8f) == Approx(0.001 * 0.64).epsilon(0.25));
}

TEST_CASE("the model grows as a power of the depth and has a floor", "[noise]") {
  NoiseModel model;
  model.factor = 0.002, model.exponent = 1.5;
  CHECK(model.sigma(4.0f) == Approx(0.016f));
  CHECK(model.sigma(1.0f) == Approx(0.002f));
  model.factor = 0.0;
  CHECK(model.sigma(1.0f) > 0.0f);
}

TEST_CASE("without any patch the default model stands", "[noise][degenerate]") {
  std::array<DepthCells, 3> empty;
  const auto models = measure_noise(empty, {});
  REQUIRE(models.size() == 3);
  for (const NoiseModel& model : models) {
    CHECK(model.sigma(1.0f) > 0.0f);
    CHECK(model.sigma(1.0f) < 0.1f);
  }
}

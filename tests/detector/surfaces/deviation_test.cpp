#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "detector/table_scene.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Errors of dimensions, in their published standard deviations.
struct Errors {
  std::vector<double> radii, lengths;
};

/// The errors of balls and cans on a table.
Errors errors_in_deviations() {
  Errors errors;
  const TableScene scene;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomStream random(seed, 0);
    const double ball = 0.03 + 0.04 * random.uniform(), can = 0.03 + 0.03 * random.uniform();
    const Eigen::Isometry3d X_CBall = scene.X_CW * translation(-0.2, 0.1 * random.uniform(), ball);
    std::vector<Patch> patches = {rectangle(scene.X_CW, 1.2, 0.9), sphere(X_CBall, ball)};
    for (const Patch& p : test::can(scene.X_CCan, can, kCanLength)) patches.push_back(p);
    Camera camera;
    camera.noise = 0.0015;
    camera.seed = seed;
    const DetectionResult result = detect(render(patches, camera), {});
    for (const auto& [type, truth] :
         {std::pair(QuadricType::kSphere, ball), std::pair(QuadricType::kCylinder, can)}) {
      const Detection* found = find(result, type);
      if (!found) continue;
      const Dimension& radius = found->dimensions.front();
      errors.radii.push_back(std::abs(radius.value - truth) / radius.std);
      if (type != QuadricType::kCylinder) continue;
      const Dimension& length = found->dimensions.back();
      errors.lengths.push_back(std::abs(length.value - kCanLength) / length.std);
    }
  }
  return errors;
}

}  // namespace

TEST_CASE("about 68 % of the true radii lie within one published deviation, 95 % within two",
          "[detector][deviation]") {
  const Errors all = errors_in_deviations();
  const std::vector<double>& errors = all.radii;
  REQUIRE(errors.size() > 60);
  const auto share_within = [&](double deviations) {
    const auto n =
        std::count_if(errors.begin(), errors.end(), [&](double e) { return e < deviations; });
    return static_cast<double>(n) / static_cast<double>(errors.size());
  };
  // Within three deviations of shares of 70 drawn, and a little for what is no white noise.
  CHECK(share_within(1) > 0.5);
  CHECK(share_within(1) < 0.92);
  CHECK(share_within(2) > 0.85);
  // Lengths err in the median by no more than a deviation, and no less than a tenth of it: these
  // cans stand free, so that no end is blurred or ragged. The median of a normal distribution is
  // 0.67.
  REQUIRE(all.lengths.size() > 30);
  std::vector<double> sorted = all.lengths;
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[sorted.size() / 2];
  CAPTURE(median);
  CHECK(median > 0.1);
  CHECK(median < 1.0);
}

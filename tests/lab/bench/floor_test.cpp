#include "lab/bench/floor.hpp"

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::bench {
namespace {

TEST_CASE("a pass adds up all coordinates", "[bench][speed]") {
  std::vector<Eigen::Vector3f> points;
  CHECK(pass_over(points) == 0.0f);
  for (int k = 1; k <= 21; ++k) points.emplace_back(k, 2 * k, -k);
  CHECK(pass_over(points) == 2.0f * 231.0f);
}

TEST_CASE("there are fewer samples than points", "[bench][speed]") {
  const scoring::Frame frame = test::make_known_frame();
  const SurfaceSamples samples = finest_samples(frame.cloud, {});
  CHECK(samples.size() > 100);
  CHECK(samples.size() < static_cast<int>(frame.cloud.points.size()));
  CHECK(finest_samples(PointCloud(), {}).size() == 0);
}

TEST_CASE("cells are made of points, and the search sees samples", "[bench][speed]") {
  CHECK(works_on("cells") == WorksOn::kPoints);
  CHECK(works_on("search") == WorksOn::kSamples);
  CHECK(works_on("a new stage") == WorksOn::kSamples);
}

}  // namespace
}  // namespace quadrille::bench

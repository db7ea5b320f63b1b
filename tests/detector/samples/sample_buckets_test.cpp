#include "samples/sample_buckets.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3f;

TEST_CASE("the buckets of a ball hold all of its samples, and few others", "[buckets]") {
  RandomStream random(3, 0);
  SurfaceSamples samples;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = 0.1 * random.uniform();
    samples.raw.push_back(Eigen::Vector3d(x - 0.5, y - 0.5, z + 1.0).cast<float>());
    samples.cell.push_back(0.004f);
  }
  samples.p = samples.n = samples.raw;
  const SampleBuckets buckets(samples);
  for (const float radius : {0.01f, 0.06f, 0.2f}) {
    for (int i = 0; i < samples.size(); i += 1999) {
      const Vector3f centre = samples.raw[i];
      std::vector<int> near = buckets.near(centre, radius);
      std::sort(near.begin(), near.end());
      CHECK(std::adjacent_find(near.begin(), near.end()) == near.end());
      int missing = 0, far = 0;
      for (int k = 0; k < samples.size(); ++k) {
        const float distance = (samples.raw[k] - centre).norm();
        const bool found = std::binary_search(near.begin(), near.end(), k);
        missing += distance <= radius && !found;
        // Buckets are 12 cells wide; those with a mean within two edges of the ball are found.
        far += distance > radius + (2 + 1.7321f) * 12 * 0.004f && found;
      }
      CHECK(missing == 0);
      CHECK(far == 0);
    }
  }
  CHECK(SampleBuckets(SurfaceSamples()).near(Vector3f::Zero(), 1.0f).empty());
}

TEST_CASE("samples without a position lie in no bucket", "[buckets][hostile]") {
  SurfaceSamples samples;
  for (int i = 0; i < 100; ++i) {
    const float x = 0.002f * static_cast<float>(i);
    samples.raw.push_back(i % 10 == 3 ? Vector3f::Constant(NAN) : Vector3f(x, 0.1f, 1.0f));
    samples.cell.push_back(0.004f);
  }
  samples.p = samples.n = samples.raw;
  const std::vector<int> near = SampleBuckets(samples).near({0.1f, 0.1f, 1.0f}, 1.0f);
  CHECK(near.size() == 90);
  CHECK(std::none_of(near.begin(), near.end(), [](int i) { return i % 10 == 3; }));
}

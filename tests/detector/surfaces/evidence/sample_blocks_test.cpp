#include "surfaces/evidence/sample_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3f;

TEST_CASE("a box holds the samples that lie in it, in whatever frame it is", "[blocks]") {
  RandomStream random(5, 0);
  SurfaceSamples samples;
  for (int i = 0; i < 5000; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = 0.1 * random.uniform();
    samples.raw.push_back(Eigen::Vector3d(x - 0.5, y - 0.5, z + 1.0).cast<float>());
    samples.cell.push_back(0.004f);
    samples.sigma.push_back(0.001f * static_cast<float>(i));
  }
  samples.p = samples.n = samples.raw;
  const SampleBlocks blocks(samples);
  const Eigen::AlignedBox3f box(Vector3f(-1.0f, -0.4f, -0.5f), Vector3f(0.5f, 1.2f, 0.6f));
  for (int i = 0; i < samples.size(); i += 499) {
    const Eigen::Affine3f X =
        Eigen::AngleAxisf(0.1f * static_cast<float>(i % 60), Vector3f(1, 2, 3).normalized()) *
        Eigen::Scaling(8.0f) * Eigen::Translation3f(-samples.raw[i]);
    std::vector<int> found = blocks.in_box(X, box), expected;
    std::sort(found.begin(), found.end());
    for (int k = 0; k < samples.size(); ++k) {
      if (box.contains(Vector3f(X * samples.raw[k]))) expected.push_back(k);
    }
    CHECK(found == expected);
    CHECK_FALSE(found.empty());
    std::vector<int> near;
    for (const SampleRows& rows : blocks.near_box(X, box)) {
      for (int k = 0; k < rows.size; ++k) {
        const int sample = static_cast<int>(std::lround(1000.0f * rows.sigma[k]));
        near.push_back(sample);
        CHECK(Vector3f(rows.x[k], rows.y[k], rows.z[k]) == samples.raw[sample]);
      }
    }
    std::sort(near.begin(), near.end());
    CHECK(std::includes(near.begin(), near.end(), found.begin(), found.end()));
  }
}

TEST_CASE("without samples a box is empty", "[blocks][degenerate]") {
  const Eigen::AlignedBox3f box(Vector3f(-1, -1, -1), Vector3f(1, 1, 1));
  CHECK(SampleBlocks(SurfaceSamples()).in_box(Eigen::Affine3f::Identity(), box).empty());
}
